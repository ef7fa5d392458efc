#include "lepp/refine/off_centre.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace lepp {

namespace {

// The part of the largest height that keeps the new angle clear of the bound.
constexpr double clearance = 0.95;

}  // namespace

OffCentre::OffCentre(double min_angle_deg)
    : height_(min_angle_deg > 0 ? clearance * 0.5 / std::tan(min_angle_deg * std::numbers::pi / 360)
                                : std::numeric_limits<double>::infinity()) {}

// On base pq the circumcentre has height cot(angle at r) / 2 relative to |pq|.
Point OffCentre::operator()(Point a, Point b, Point c) const {
  Point p = b, q = c, r = a;
  double shortest = squared_distance(b, c);
  const double ca = squared_distance(c, a), ab = squared_distance(a, b);
  if (ca < shortest) {
    p = c, q = a, r = b;
    shortest = ca;
  }
  if (ab < shortest) p = a, q = b, r = c;
  const Point base = q - p, to_p = p - r, to_q = q - r;
  const double at_circumcentre = 0.5 * dot(to_p, to_q) / cross(to_p, to_q);
  const double height = std::min(at_circumcentre, height_);
  return p + Point{0.5 * base.x - height * base.y, 0.5 * base.y + height * base.x};
}

}  // namespace lepp
