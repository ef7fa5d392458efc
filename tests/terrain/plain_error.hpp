#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lepp/geometry/predicates.hpp"
#include "lepp/terrain/simplify.hpp"

namespace lepp::test {

struct PlainError {
  double max = 0, sum_of_squares = 0;
  std::size_t samples = 0, lost = 0, covered = 0;
};

/// The error of a TIN by asking, for each sample, each triangle: is it inside (exact)?
/// \pre square cells: then places of samples are whole numbers, and vertices are samples
inline PlainError plain_error(const HeightGrid& grid, const Tin& tin) {
  PlainError error;
  for (std::uint32_t row = 0; row < grid.rows; ++row) {
    for (std::uint32_t column = 0; column < grid.columns; ++column) {
      const Point p = grid.sample(column, grid.row_of_line(row));
      bool found = false;
      double largest = 0;
      for (std::size_t i = 0; i < tin.mesh.triangle_count(); ++i) {
        const TriangleId t(i);
        const auto [a, b, c] = tin.mesh.corners(t);
        if (orient2d(a, b, p) < 0 || orient2d(b, c, p) < 0 || orient2d(c, a, p) < 0) continue;
        const double whole = cross(b - a, c - a);
        const auto height = [&](std::uint32_t k) {
          return tin.heights[tin.mesh.vertex(t, k).index()];
        };
        // Above the first corner: far from 0 sums of heights are rounded, differences are not.
        const double z = (cross(a - c, p - c) * (height(1) - height(0)) +
                          cross(b - a, p - a) * (height(2) - height(0))) /
                         whole;
        if (grid.has_data(column, row)) {
          largest = std::max(largest, std::abs(grid.height(column, row) - height(0) - z));
        }
        found = true;
      }
      if (!grid.has_data(column, row)) {
        error.covered += found ? 1 : 0;
        continue;
      }
      error.lost += found ? 0 : 1;
      error.samples += found ? 1 : 0;
      error.max = std::max(error.max, largest);
      error.sum_of_squares += largest * largest;
    }
  }
  return error;
}

}  // namespace lepp::test
