#include "lepp/geometry/segment_intersection.hpp"

#include <algorithm>
#include <cmath>

#include "lepp/geometry/expansion.hpp"
#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/pslg.hpp"

namespace lepp {

namespace {

SegmentMeeting collinear_meeting(Point a, Point b, Point c, Point d) {
  const auto [low_1, high_1] = std::minmax(a, b);
  const auto [low_2, high_2] = std::minmax(c, d);
  const Point low = std::max(low_1, low_2), high = std::min(high_1, high_2);
  if (high < low) return SegmentMeeting::apart;
  if (low < high || low_1 == high_1 || low_2 == high_2) return SegmentMeeting::overlapping;
  return SegmentMeeting::at_shared_end;
}

// The sum of an expansion, rounded, and most of what rounding lost.
template <std::size_t N>
RoundedPair leading(const Expansion<N>& e) {
  if (e.size() == 0) return {0, 0};
  double rest = 0;
  for (std::size_t i = 0; i + 1 < e.size(); ++i) rest += e[i];
  return fast_two_sum(e[e.size() - 1], rest);
}

// numerator / denominator, rounded to the nearest double of the supported range.
template <std::size_t M, std::size_t N>
double quotient(const Expansion<M>& numerator, const Expansion<N>& denominator) {
  const double below = leading(denominator).value;
  const double first = leading(numerator).value / below;
  if (std::abs(first) < 0.5 * min_coordinate) return 0;
  const double rest = leading(numerator - scale(denominator, first)).value;
  const double rounded = first + rest / below;
  if (std::abs(rounded) >= min_coordinate) return rounded;
  return std::abs(rounded) < 0.5 * min_coordinate ? 0 : std::copysign(min_coordinate, rounded);
}

}  // namespace

std::string describe(SegmentMeeting meeting) {
  switch (meeting) {
    case SegmentMeeting::apart:
      return "do not meet";
    case SegmentMeeting::at_shared_end:
      return "share an end";
    case SegmentMeeting::touching:
      return "touch: an end of one lies inside the other";
    case SegmentMeeting::crossing:
      return "cross";
    case SegmentMeeting::overlapping:
      return "overlap";
  }
  return {};
}

bool is_on_segment(Point p, Point a, Point b) {
  if (orient2d(a, b, p) != 0) return false;
  const auto [low, high] = std::minmax(a, b);
  return low <= p && p <= high;
}

SegmentMeeting segments_meet(Point a, Point b, Point c, Point d) {
  const int c_side = orient2d(a, b, c), d_side = orient2d(a, b, d);
  if (c_side == 0 && d_side == 0) return collinear_meeting(a, b, c, d);
  if (c_side * d_side > 0) return SegmentMeeting::apart;
  const int a_side = orient2d(c, d, a), b_side = orient2d(c, d, b);
  if (a_side * b_side > 0) return SegmentMeeting::apart;
  if (c_side * d_side < 0 && a_side * b_side < 0) return SegmentMeeting::crossing;
  if (a == c || a == d || b == c || b == d) return SegmentMeeting::at_shared_end;
  return SegmentMeeting::touching;
}

Point crossing_point(Point a, Point b, Point c, Point d) {
  // a + s (b - a) with s = cross(c - a, d - c) / cross(b - a, d - c), as one exact fraction.
  const auto x_ab = difference(b.x, a.x), y_ab = difference(b.y, a.y);
  const auto x_cd = difference(d.x, c.x), y_cd = difference(d.y, c.y);
  const auto above = difference(c.x, a.x) * y_cd - difference(c.y, a.y) * x_cd;
  const auto below = x_ab * y_cd - y_ab * x_cd;
  return {quotient(scale(below, a.x) + above * x_ab, below),
          quotient(scale(below, a.y) + above * y_ab, below)};
}

int order_along(Point a, Point b, Point p, Point q) {
  const double x = (b.x - a.x) * (q.x - p.x), y = (b.y - a.y) * (q.y - p.y);
  const double bound = 0x1p-50 * (std::abs(x) + std::abs(y));
  if (std::abs(x + y) > bound) return x + y > 0 ? 1 : -1;
  const auto along_x = difference(b.x, a.x) * difference(q.x, p.x);
  const auto along_y = difference(b.y, a.y) * difference(q.y, p.y);
  return (along_x + along_y).sign();
}

}  // namespace lepp
