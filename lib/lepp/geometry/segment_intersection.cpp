#include "lepp/geometry/segment_intersection.hpp"

#include <algorithm>
#include <cmath>

#include "lepp/geometry/predicates.hpp"

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
  // In coordinates relative to a, along the direction that loses least: the parameter of cd's line
  // on ab. The quotient lies in [0, 1] up to rounding.
  const Point ab = b - a, cd = d - c;
  const double across = cross(ab, cd);
  const double s = std::clamp(cross(c - a, cd) / across, 0.0, 1.0);
  return s <= 0.5 ? a + s * ab : b - (1 - s) * ab;
}

}  // namespace lepp
