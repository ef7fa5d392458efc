#pragma once

#include <algorithm>

#include "lepp/geometry/point.hpp"

namespace lepp {

/// The place of a segment that is nearest to a point, rounded.
struct PlaceOnSegment {
  double along = 0;  ///< from the first end (0) to the second one (1)
  double squared_distance = 0;
};

/// The place of segment ab that is nearest to `p`; `a` if that is all of it.
inline PlaceOnSegment nearest_place(Point a, Point b, Point p) {
  const Point d = b - a;
  const double whole = dot(d, d);
  const double along = whole > 0 ? std::clamp(dot(p - a, d) / whole, 0.0, 1.0) : 0;
  return {along, squared_distance(a + along * d, p)};
}

}  // namespace lepp
