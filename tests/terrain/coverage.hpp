#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lepp/geometry/predicates.hpp"
#include "lepp/terrain/height_grid.hpp"
#include "lepp/triangulation/mesh.hpp"

namespace lepp::test {

struct Coverage {
  std::size_t lost = 0;     ///< samples with data in no closed triangle
  std::size_t covered = 0;  ///< samples without data in one
};

/// Counts samples in closed triangles, decided exactly.
inline Coverage coverage(const HeightGrid& grid, const Mesh& mesh) {
  std::vector<bool> inside(grid.size());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    const double aspect = grid.aspect();
    const auto low = [](double x) { return std::max(0.0, std::floor(x)); };
    const double x_end = std::min(std::ceil(std::max({a.x, b.x, c.x})), grid.columns - 1.0);
    const double y_end = std::min(std::ceil(std::max({a.y, b.y, c.y}) / aspect), grid.rows - 1.0);
    for (double y = low(std::min({a.y, b.y, c.y}) / aspect); y <= y_end; ++y) {
      for (double x = low(std::min({a.x, b.x, c.x})); x <= x_end; ++x) {
        const auto column = static_cast<std::uint32_t>(x), line = static_cast<std::uint32_t>(y);
        const Point p = grid.sample(column, line);
        if (orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 && orient2d(c, a, p) >= 0)
          inside[grid.index(column, grid.row_of_line(line))] = true;
      }
    }
  }
  Coverage result;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (std::isnan(grid.heights[i])) result.covered += inside[i];
    else result.lost += !inside[i];
  }
  return result;
}

}  // namespace lepp::test
