// Each .asc in this folder once showed a bug of terrain simplification, told in README.md. By
// either metric the error must be kept, and the angles.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "lepp/io/height_grid_read.hpp"
#include "lepp/terrain/terrain_domain.hpp"
#include "lepp/terrain/world_tin.hpp"
#include "terrain/surface_grids.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

void check(const HeightGrid& grid, const SimplifyOptions& options) {
  SimplifyReport report;
  const Tin tin = simplify(grid, terrain_domain(grid), options, report);
  CHECK(report.goal_reached);
  CHECK(report.error.lost == 0);
  CHECK(tin.mesh.vertex_count() < 20 * grid.size());
  CHECK(validate(to_world(tin, grid).mesh, {.delaunay = false}).summary() == "valid");
  if (options.metric == TerrainMetric::planar) return;
  check_surface(grid, tin, report, std::min(15.0, options.min_angle_deg));
}

}  // namespace

TEST_CASE("grids that once showed a bug give TINs that keep their bounds, by either metric") {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(LEPP_REGRESSION)) {
    if (entry.path().extension() != ".asc") continue;
    ++files;
    CAPTURE(entry.path().filename().string());
    const HeightGrid grid = read_height_grid(entry.path());
    double high = 0;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      high = std::max(high, std::isnan(grid.heights[i]) ? 0.0 : grid.heights[i]);
    }
    for (const double part : {0.0, 0.01, 0.05}) {
      for (const Effort effort : {Effort::fast, Effort::normal, Effort::best}) {
        for (const TerrainMetric metric : {TerrainMetric::planar, TerrainMetric::surface}) {
          CAPTURE(part);
          SimplifyOptions options{.max_error = part * high, .effort = effort};
          options.metric = metric;
          check(grid, options);
          options.min_angle_deg = 5;
          options.level_errors = {8 * options.max_error, 2 * options.max_error};
          check(grid, options);
        }
      }
    }
  }
  CHECK(files >= 6);
}
