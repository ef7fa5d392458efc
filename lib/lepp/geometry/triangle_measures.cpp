#include "lepp/geometry/triangle_measures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lepp {

namespace {

double angle_deg(Point a, Point apex, Point b) {
  const Point u = a - apex, w = b - apex;
  return std::atan2(std::abs(cross(u, w)), dot(u, w)) * (180 / std::numbers::pi);
}

// Turns a triangle until the edge opposite `a` is its longest: the angle at `a` then is the one
// nearest to a right angle, or above it, where differences cancel least.
void turn_longest_opposite_a(Point& a, Point& b, Point& c) {
  const double opposite_a = squared_distance(b, c);
  const double opposite_b = squared_distance(c, a);
  const double opposite_c = squared_distance(a, b);
  if (opposite_b > opposite_a && opposite_b >= opposite_c) {
    std::swap(a, b);  // a b c -> b c a
    std::swap(b, c);
  } else if (opposite_c > opposite_a) {
    std::swap(a, c);  // a b c -> c a b
    std::swap(b, c);
  }
}

}  // namespace

double signed_area(Point a, Point b, Point c) { return 0.5 * cross(b - a, c - a); }

std::array<double, 3> angles_deg(Point a, Point b, Point c) {
  return {angle_deg(c, a, b), angle_deg(a, b, c), angle_deg(b, c, a)};
}

Point circumcenter(Point a, Point b, Point c) {
  turn_longest_opposite_a(a, b, c);
  const Point u = b - a, w = c - a;
  const double uu = dot(u, u), ww = dot(w, w);
  const double scale = 0.5 / cross(u, w);
  return a + Point{(w.y * uu - u.y * ww) * scale, (u.x * ww - w.x * uu) * scale};
}

double squared_cos_of_smallest_angle(Point a, Point b, Point c) {
  const double opposite_a = squared_distance(b, c);
  const double opposite_b = squared_distance(c, a);
  const double opposite_c = squared_distance(a, b);
  const auto squared_cos = [](Point left, Point apex, Point right, double uu, double ww) {
    const double uw = dot(left - apex, right - apex);
    return uw * std::abs(uw) / (uu * ww);
  };
  if (opposite_a <= opposite_b && opposite_a <= opposite_c) {
    return squared_cos(b, a, c, opposite_c, opposite_b);
  }
  if (opposite_b <= opposite_c) return squared_cos(c, b, a, opposite_a, opposite_c);
  return squared_cos(a, c, b, opposite_b, opposite_a);
}

double cotangent(Point a, Point apex, Point b) {
  const Point u = a - apex, w = b - apex;
  return dot(u, w) / std::abs(cross(u, w));
}

bool is_below_60_deg(Point a, Point apex, Point b) {
  const Point u = a - apex, w = b - apex;
  const double uw = dot(u, w), area = cross(u, w);
  return uw > 0 && area * area < 3 * (uw * uw);  // tan < sqrt 3
}

bool is_below_45_deg(Point a, Point apex, Point b) {
  const Point u = a - apex, w = b - apex;
  return std::abs(cross(u, w)) < dot(u, w);  // tan < 1
}

}  // namespace lepp
