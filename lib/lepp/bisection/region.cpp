#include "lepp/bisection/region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lepp/geometry/place_on_segment.hpp"
#include "lepp/geometry/predicates.hpp"

namespace lepp {

namespace {

using Corners = std::array<Point, 3>;

bool contains(const Corners& t, Point p) {
  return orient2d(t[0], t[1], p) >= 0 && orient2d(t[1], t[2], p) >= 0 &&
         orient2d(t[2], t[0], p) >= 0;
}

bool meets_disc(const Disc& disc, const Corners& t) {
  if (contains(t, disc.center)) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    const double least = nearest_place(t[i], t[(i + 1) % 3], disc.center).squared_distance;
    if (least <= disc.radius * disc.radius) return true;
  }
  return false;
}

// Boxes around both are apart.
bool are_apart(const Corners& t, Point low, Point high) {
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [bottom, top] = std::minmax({t[0].y, t[1].y, t[2].y});
  return right < low.x || left > high.x || top < low.y || bottom > high.y;
}

// Two convex polygons are apart if and only if a side of one of them has the other one beyond it.
bool meets_box(const Box& box, const Corners& t) {
  if (are_apart(t, box.low, box.high)) return false;
  const std::array<Point, 4> corners{box.low, Point{box.high.x, box.low.y}, box.high,
                                     Point{box.low.x, box.high.y}};
  for (std::size_t i = 0; i < 3; ++i) {
    const bool beyond = std::ranges::all_of(
        corners, [&](Point p) { return orient2d(t[i], t[(i + 1) % 3], p) < 0; });
    if (beyond) return false;
  }
  return true;
}

bool segments_meet(Point a, Point b, Point c, Point d) {
  const int abc = orient2d(a, b, c), abd = orient2d(a, b, d);
  const int cda = orient2d(c, d, a), cdb = orient2d(c, d, b);
  if (abc == 0 && abd == 0) {  // on one line: their boxes tell
    const auto [p, q] = std::minmax(a, b);
    const auto [r, s] = std::minmax(c, d);
    return !(q < r) && !(s < p);
  }
  return abc * abd <= 0 && cda * cdb <= 0;
}

bool meets_polygon(const PolygonArea& polygon, const Corners& t) {
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [bottom, top] = std::minmax({t[0].y, t[1].y, t[2].y});
  const auto is_met = [&](Point a, Point b) {
    if (contains(t, a)) return true;
    for (std::size_t k = 0; k < 3; ++k) {
      if (segments_meet(a, b, t[k], t[(k + 1) % 3])) return true;
    }
    return false;
  };
  return polygon.any_side_near({left, bottom}, {right, top}, is_met) || polygon.contains(t[0]);
}

}  // namespace

bool meets(const Region& region, const std::array<Point, 3>& triangle) {
  if (const auto* disc = std::get_if<Disc>(&region)) return meets_disc(*disc, triangle);
  if (const auto* box = std::get_if<Box>(&region)) return meets_box(*box, triangle);
  return meets_polygon(std::get<PolygonArea>(region), triangle);
}

double distance(const Region& region, Point p) {
  if (const auto* disc = std::get_if<Disc>(&region)) {
    return std::max(0.0, std::sqrt(squared_distance(p, disc->center)) - disc->radius);
  }
  if (const auto* box = std::get_if<Box>(&region)) {
    const Point nearest{std::clamp(p.x, box->low.x, box->high.x),
                        std::clamp(p.y, box->low.y, box->high.y)};
    return std::sqrt(squared_distance(p, nearest));
  }
  const auto& polygon = std::get<PolygonArea>(region);
  return polygon.contains(p) ? 0 : std::sqrt(polygon.squared_distance_from_sides(p));
}

}  // namespace lepp
