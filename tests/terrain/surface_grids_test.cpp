// Random small grids by the surface metric: cells of any shape, ground of any steepness.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lepp/terrain/terrain_domain.hpp"
#include "lepp/terrain/world_tin.hpp"
#include "terrain/surface_grids.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

template <std::size_t n>
double one_of(Random& random, const std::array<double, n>& values) {
  return values[random.below(n)];
}

// Noise, few whole numbers, spikes, steps or a ramp; from 0 to 1.
double random_height(Random& random, std::uint32_t kind, double x, double y) {
  switch (kind) {
    case 0:
      return random.real();
    case 1:
      return random.below(4) / 3.0;
    case 2:
      return random.one_in(4) ? 1 : 0.002 * random.real();
    case 3:
      return std::floor((x + y) / 3) / 8;
    default:
      return (x + 2 * y) / 36 + (random.one_in(10) ? 0.1 : 0);
  }
}

// Up to 12 x 12 samples, relief from a hundredth of the width to a hundred times that.
HeightGrid random_grid(Random& random, bool has_holes) {
  const std::uint32_t columns = 2 + random.below(11), rows = 2 + random.below(11);
  const std::uint32_t kind = random.below(5);
  const double relief = columns * std::pow(10, random.real(-2, 2));
  HeightGrid grid = grid_of(columns, rows, [&](double x, double y) {
    return relief * random_height(random, kind, x, y);
  });
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (has_holes && random.one_in(8)) {
      grid.heights.set(i, std::numeric_limits<double>::quiet_NaN());
    }
  }
  grid.heights.set(0, 0);  // one sample at least
  grid.cell_height = one_of(random, std::array{0.1, 0.2, 0.3, 0.5, 1.0, 2.0, 3.0, 5.0, 6.0, 10.0});
  grid.step_y = -grid.cell_height;
  return grid;
}

SimplifyOptions random_options(Random& random, const HeightGrid& grid) {
  double high = 0;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    high = std::max(high, std::isnan(grid.heights[i]) ? 0.0 : grid.heights[i]);
  }
  SimplifyOptions options{.max_error = one_of(random, std::array{0.0, 0.01, 0.05, 0.2}) * high};
  options.metric = TerrainMetric::surface;
  options.effort = std::array{Effort::fast, Effort::normal, Effort::best}[random.below(3)];
  return options;
}

}  // namespace

TEST_CASE("Surface metric: random grids of any cells and relief keep their bounds and angles") {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const HeightGrid grid = random_grid(random, seed % 4 == 0);
    CAPTURE(grid.columns);
    CAPTURE(grid.rows);
    CAPTURE(grid.cell_height);
    const SimplifyOptions options = random_options(random, grid);
    SimplifyReport report;
    const Tin tin = simplify(grid, terrain_domain(grid), options, report);
    CHECK(report.goal_reached);
    CHECK((seed % 4 == 0 || report.unfinished.empty()));
    CHECK(report.error.lost == 0);
    CHECK(report.error.covered == 0);
    CHECK(tin.mesh.vertex_count() < 20 * grid.size());
    CHECK(validate(to_world(tin, grid).mesh, {.delaunay = false}).summary() == "valid");
    check_surface(grid, tin, report);
  }
}
