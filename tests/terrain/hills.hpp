#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "lepp/terrain/height_grid.hpp"
#include "lepp/terrain/simplify.hpp"
#include "lepp/terrain/terrain_domain.hpp"
#include "support/random.hpp"
#include "support/shapes.hpp"

namespace lepp::test {

/// A grid whose heights are height(column, row of the file).
template <class Height>
HeightGrid grid_of(std::uint32_t columns, std::uint32_t rows, Height height) {
  HeightGrid grid;
  grid.columns = columns;
  grid.rows = rows;
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      grid.heights.push_back(static_cast<float>(height(column, row)));
    }
  }
  return grid;
}

/// The same with heights that need not be floats.
template <class Height>
HeightGrid exact_grid_of(std::uint32_t columns, std::uint32_t rows, Height height) {
  HeightGrid grid = grid_of(columns, rows, [](double, double) { return 0; });
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column)
      grid.heights.set(grid.index(column, row), height(column, row));
  }
  return grid;
}

inline void raise(HeightGrid& grid, std::uint32_t column, std::uint32_t row, double by) {
  grid.heights.set(grid.index(column, row), grid.height(column, row) + by);
}

/// Smooth hills 100 high; some 20 cells from top to top.
inline double hill(double x, double y) {
  return 50 * (std::sin(0.31 * x) * std::cos(0.23 * y) + std::sin(0.07 * x + 0.11 * y));
}
inline HeightGrid hills(std::uint32_t columns, std::uint32_t rows) {
  return grid_of(columns, rows, [](double x, double y) { return hill(x, y); });
}
/// Hills in whole numbers, with a cliff across and noise: flat places, ties and jumps.
inline HeightGrid rough(std::uint32_t columns, std::uint32_t rows, std::uint64_t seed) {
  Random random(seed);
  return grid_of(columns, rows, [&](double x, double y) {
    const double noise = static_cast<double>(random.below(5));
    return std::round(hill(x, y) + noise + (x > y + 3 ? 40 : 0));
  });
}

/// The whole grid, its four corners.
inline TerrainDomain rectangle(const HeightGrid& grid) {
  const double w = grid.columns - 1, h = (grid.rows - 1) * grid.aspect();
  TerrainDomain domain;
  domain.pslg = polygon({0, 0, w, 0, w, h, 0, h});
  return domain;
}

}  // namespace lepp::test
