// height_at() for grids without gaps, where the library does not define it.

#include <algorithm>

#include "lepp/terrain/terrain_domain.hpp"

__attribute__((weak)) double lepp::height_at(const HeightGrid& grid, Point p) {
  const double x = std::clamp(p.x, 0.0, grid.columns - 1.0);
  const double y = std::clamp(p.y / grid.aspect(), 0.0, grid.rows - 1.0);
  const auto c = static_cast<std::uint32_t>(std::min(x, grid.columns - 2.0));
  const auto l = static_cast<std::uint32_t>(std::min(y, grid.rows - 2.0));
  const auto along = [&](std::uint32_t line) {
    const double low = grid.height(c, grid.row_of_line(line));
    return low + (x - c) * (grid.height(c + 1, grid.row_of_line(line)) - low);
  };
  return along(l) + (y - l) * (along(l + 1) - along(l));
}
