#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lepp/terrain/terrain_domain.hpp"

namespace lepp {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// A place between samples: the sample to the south-west, and the shares of a cell beyond it.
struct CellPlace {
  std::uint32_t column = 0, line = 0;
  double u = 0, v = 0;
};

CellPlace cell_place(const HeightGrid& grid, Point p) {
  const double x = std::clamp(p.x, 0.0, double(grid.columns - 1));
  const double y = std::clamp(p.y / grid.aspect(), 0.0, double(grid.rows - 1));
  const double column = std::floor(x), line = std::floor(y);
  return {static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(line), x - column,
          y - line};
}

double between(double a, double b, double share) { return a + share * (b - a); }

// sw, se, nw, ne, one of them NaN: in the plane of the others, if the place is in their triangle.
double in_triangle(const std::array<double, 4>& h, double u, double v) {
  const auto [sw, se, nw, ne] = h;
  if (std::isnan(ne) && u + v <= 1) return sw + u * (se - sw) + v * (nw - sw);
  if (std::isnan(sw) && u + v >= 1) return ne + (1 - u) * (nw - ne) + (1 - v) * (se - ne);
  if (std::isnan(nw) && u >= v) return se + (1 - u) * (sw - se) + v * (ne - se);
  if (std::isnan(se) && u <= v) return nw + u * (ne - nw) + (1 - v) * (sw - nw);
  return none;
}

// Looks at squares of growing size around the place, until no closer sample can come.
double of_nearest(const HeightGrid& grid, const CellPlace& place) {
  const double aspect = grid.aspect(), side = std::min(1.0, aspect);
  const double x = place.column + place.u, y = place.line + place.v;
  const auto columns = std::int64_t{grid.columns}, rows = std::int64_t{grid.rows};
  double nearest = none, least = std::numeric_limits<double>::infinity();
  const auto look = [&](std::int64_t column, std::int64_t line) {
    if (column < 0 || column >= columns || line < 0 || line >= rows) return;
    const double height = grid.height(static_cast<std::uint32_t>(column),
                                      grid.row_of_line(static_cast<std::uint32_t>(line)));
    const double dx = double(column) - x, dy = (double(line) - y) * aspect;
    const double distance = dx * dx + dy * dy;
    if (std::isnan(height) || distance >= least) return;
    least = distance;
    nearest = height;
  };
  const std::int64_t column = place.column, line = place.line;
  for (std::int64_t ring = 0; ring < std::max(columns, rows); ++ring) {
    // Ring k is all samples k columns or lines from the corner of the cell: at least k - 1 away.
    const double reach = double(ring - 1) * side;
    if (reach > 0 && reach * reach > least) break;
    for (std::int64_t d = -ring; d <= ring; ++d) {
      look(column + d, line - ring);
      if (ring > 0) look(column + d, line + ring);
      if (d == -ring || d == ring) continue;
      look(column - ring, line + d);
      look(column + ring, line + d);
    }
  }
  return nearest;
}

}  // namespace

double height_at(const HeightGrid& grid, Point p) {
  const CellPlace place = cell_place(grid, p);
  const auto [column, line, u, v] = place;
  const std::uint32_t east = u > 0 ? 1 : 0, north = v > 0 ? 1 : 0;  // 0: on the line itself
  const std::uint32_t south_row = grid.row_of_line(line);
  const std::uint32_t north_row = grid.row_of_line(line + north);
  const std::array<double, 4> h = {
      grid.height(column, south_row), grid.height(column + east, south_row),
      grid.height(column, north_row), grid.height(column + east, north_row)};
  const double bilinear = between(between(h[0], h[1], u), between(h[2], h[3], u), v);
  if (!std::isnan(bilinear)) return bilinear;
  if (east != 0 && north != 0) {
    const double plane = in_triangle(h, u, v);
    if (!std::isnan(plane)) return plane;
  }
  return of_nearest(grid, place);
}

}  // namespace lepp
