#pragma once

#include <limits>
#include <string>
#include <vector>

#include "lepp/terrain/height_grid.hpp"

namespace lepp::test {

/// A grid from a picture, the northern row first: a digit is a height, '.' is no data.
inline HeightGrid grid_of(const std::vector<std::string>& rows, double aspect = 1) {
  HeightGrid grid;
  grid.source = "picture";
  grid.columns = static_cast<std::uint32_t>(rows.front().size());
  grid.rows = static_cast<std::uint32_t>(rows.size());
  for (const std::string& row : rows) {
    for (const char c : row) {
      grid.heights.push_back(c == '.' ? std::numeric_limits<float>::quiet_NaN()
                                      : static_cast<float>(c - '0'));
    }
  }
  grid.cell_height = aspect;
  grid.step_y = -aspect;
  grid.origin = {0, (grid.rows - 1) * aspect};
  return grid;
}

}  // namespace lepp::test
