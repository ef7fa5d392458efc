#pragma once

#include <array>
#include <variant>

#include "lepp/bisection/polygon_area.hpp"
#include "lepp/geometry/point.hpp"

namespace lepp {

/// Parts of the plane, each with its border: where a mesh is to be fine.
struct Disc {
  Point center;
  double radius = 0;  ///< >= 0
};
struct Box {
  Point low, high;  ///< low.x <= high.x, low.y <= high.y
};
using Region = std::variant<Disc, Box, PolygonArea>;

/// True if the closed triangle and the region have a point in common. Exact for the box and the
/// polygon but for the rounding of coordinates, to rounding for the disc.
/// \pre  `triangle` is counter-clockwise.  Cost O(1), for a polygon as said there
bool meets(const Region& region, const std::array<Point, 3>& triangle);

/// How far `p` is from the region, 0 inside. To rounding. Cost as above
double distance(const Region& region, Point p);

}  // namespace lepp
