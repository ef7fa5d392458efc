#include "lepp/io/grid_placement.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/pslg.hpp"
#include "lepp/geometry/text.hpp"

namespace lepp {

namespace {

void set_cell(const std::optional<CellSize>& cell, HeightGrid& grid) {
  if (cell) {
    const auto [width, height] = *cell;
    if (!(width > 0 && height > 0 && std::isfinite(width) && std::isfinite(height)))
      throw InputError("the cell size", "is not above 0", "give width and height of a cell");
    grid.cell_width = width;
    grid.cell_height = height;
  } else if (grid.degrees) {
    set_cell_from_degrees(grid);
  } else if (grid.georeferenced) {
    grid.cell_width = grid.step_x;
    grid.cell_height = std::abs(grid.step_y);
  }
}

void check_cell(const HeightGrid& grid) {
  constexpr double longest = 0x1p20;
  const double aspect = grid.cell_height / grid.cell_width;
  const auto fits = [](double size) { return size >= min_coordinate && size <= max_coordinate; };
  if (fits(grid.cell_width) && fits(grid.cell_height) && aspect * longest >= 1 && aspect <= longest)
    return;
  throw InputError(grid.source,
                   "its cells are " + to_text(grid.cell_width) + " wide and " +
                       to_text(grid.cell_height) + " high",
                   "correct the sizes: sides may differ by a factor of a million");
}

// `begin` and `end`: the first and the last sample.
void check_axis(const HeightGrid& grid, const std::string& axis, double begin, double end,
                double step) {
  const double largest = std::max(std::abs(begin), std::abs(end));
  // Beyond, samples side by side may have the same coordinate. What can be told apart but leaves
  // little between is for check_world_rounding() to judge, after coordinates were made smaller.
  constexpr double most_steps = 0x1p52;
  constexpr double smallest_step = 0x1p-80;  // so that differences of coordinates are no smaller
                                             // than min_coordinate
  const std::string of_axis = "its " + axis + " coordinates ";
  if (!std::isfinite(begin) || !std::isfinite(end))
    throw InputError(grid.source, of_axis + "are not finite", "correct its georeference");
  if (largest > max_coordinate)
    throw InputError(grid.source, of_axis + "are larger than 1.6e60", "choose another unit");
  if (step < smallest_step)
    throw InputError(grid.source, of_axis + "have steps smaller than 8.3e-25",
                     "choose another unit");
  if (largest < step * most_steps) return;
  throw InputError(grid.source,
                   of_axis + "are as large as " + to_text(largest) +
                       ", and numbers of that size cannot hold steps of " + to_text(step),
                   "subtract an offset from them, or correct the cell size");
}

}  // namespace

void place_grid(const std::optional<CellSize>& cell, HeightGrid& grid) {
  set_cell(cell, grid);
  check_cell(grid);
  if (!grid.georeferenced) {
    grid.step_x = grid.cell_width;
    grid.step_y = -grid.cell_height;
    grid.origin = {0, double(grid.rows - 1) * grid.cell_height};
  }
  const Point first = grid.origin;
  check_axis(grid, "x", first.x, first.x + double(grid.columns - 1) * grid.step_x, grid.step_x);
  check_axis(grid, "y", first.y, first.y + double(grid.rows - 1) * grid.step_y,
             std::abs(grid.step_y));
}

}  // namespace lepp
