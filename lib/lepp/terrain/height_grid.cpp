#include "lepp/terrain/height_grid.hpp"

#include <algorithm>
#include <numbers>
#include <string>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/text.hpp"

namespace lepp {

bool HeightGrid::has_any_data() const {
  return heights.visit([](auto all) {
    return std::ranges::any_of(all, [](auto height) { return !std::isnan(height); });
  });
}

void set_cell_from_degrees(HeightGrid& grid) {
  constexpr double radian = std::numbers::pi / 180;
  constexpr double equator = 6378137, squared_eccentricity = 0.00669438;
  const double latitude = grid.origin.y + 0.5 * double(grid.rows - 1) * grid.step_y;
  if (!(std::abs(latitude) < 90)) {
    throw InputError(grid.source, "is in degrees, but its middle latitude is " + to_text(latitude),
                     "correct its georeference");
  }
  const double sine = std::sin(latitude * radian);
  const double w = 1 - squared_eccentricity * sine * sine;
  const double along_parallel = equator / std::sqrt(w) * std::cos(latitude * radian);
  const double along_meridian = equator * (1 - squared_eccentricity) / (w * std::sqrt(w));
  grid.cell_width = grid.step_x * radian * along_parallel;
  grid.cell_height = std::abs(grid.step_y) * radian * along_meridian;
}

void check_usable(const HeightGrid& grid) {
  if (grid.columns < 2 || grid.rows < 2) {
    throw InputError(grid.source,
                     "a grid of " + std::to_string(grid.columns) + " x " +
                         std::to_string(grid.rows) + " samples has no area between them",
                     "give at least two columns and two rows");
  }
  if (grid.has_any_data()) return;
  throw InputError(grid.source, "all " + std::to_string(grid.size()) + " samples are without data",
                   "check the value that means no data");
}

}  // namespace lepp
