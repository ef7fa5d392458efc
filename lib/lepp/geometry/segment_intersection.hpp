#pragma once

#include <string>

#include "lepp/geometry/point.hpp"

namespace lepp {

/// How two segments meet, decided exactly.
enum class SegmentMeeting {
  apart,
  at_shared_end,  ///< one end of each has the same coordinates, and nothing else is shared
  touching,       ///< an end of one lies inside the other
  crossing,       ///< at one point inside both
  overlapping,    ///< they share a piece of a line, or one is a point
};

std::string describe(SegmentMeeting meeting);

/// \pre coordinates in the supported range. Cost: at most four orientation tests.
SegmentMeeting segments_meet(Point a, Point b, Point c, Point d);

/// True if p lies on the closed segment ab, exactly.
bool is_on_segment(Point p, Point a, Point b);

/// The crossing of ab and cd, rounded to the nearest double of the supported range; it may lie off
/// both lines by half an ulp in x and in y.
/// \pre  the segments cross at one point inside both
Point crossing_point(Point a, Point b, Point c, Point d);

/// +1 if q lies further than p in the direction from a to b, -1 if less far, 0 if neither, exactly.
int order_along(Point a, Point b, Point p, Point q);

}  // namespace lepp
