// Grids of other programs, through LEPP_TEST_DATA.

#include <doctest/doctest.h>

#include <cmath>

#include "io/scratch_folder.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/io/height_grid_read.hpp"
#include "lepp/terrain/terrain_domain.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/real_inputs.hpp"
#include "terrain/coverage.hpp"

using namespace lepp;
using test::contains;
using test::error_of;

TEST_CASE("the nasty grids are refused or read as their list says") {
  const auto fate = [](const std::string& name) -> std::string {
    const auto path = test::real_input("nasty/" + name);
    if (!path) return "skipped";
    return error_of<InputError>([&] { read_height_grid(*path); });
  };
  if (!test::real_input("nasty/d01_all_nodata.asc")) return;
  CHECK(contains(fate("d01_all_nodata.asc"), "all 30 samples are without data"));
  CHECK(contains(fate("d03_one_cell.asc"), "1 x 1 samples has no area"));
  CHECK(contains(fate("d05_ragged_row.asc"), "holds 11 values, but its header says 12"));
  CHECK(contains(fate("d05_ragged_row.asc"), "line 8 is short"));
  CHECK(contains(fate("d07_cellsize_negative.asc"), "cellsize is -30"));
  CHECK(contains(fate("d09_dims_1e5x1e5.asc"), "holds 4 values, but its header says 10000000000"));
  CHECK(contains(fate("d15_too_many_values.asc"), "holds 12 values, but its header says 9"));
  CHECK(contains(fate("d17_negative_dims.asc"), "ncols is -20"));

  const HeightGrid centers =
      read_height_grid(*test::real_input("nasty/d11_utm_offset_llcenter.asc"));
  CHECK(centers.to_world({0, 0}) == Point{500015.5, 4649790.25});
  const HeightGrid oblong = read_height_grid(*test::real_input("nasty/d13_dx_dy.asc"));
  CHECK(oblong.step_x == 30);
  CHECK(oblong.step_y == -10);
}

TEST_CASE("real grids have the size and the range that their list gives") {
  struct Known {
    const char* name;
    std::uint32_t columns, rows;
    double low, high;
    std::size_t without;
  };
  for (const Known& known :
       {Known{"ashby.stm", 346, 452, 113, 587, 0}, Known{"crater.stm", 336, 459, 1533, 2478, 0},
        Known{"jacksboro.npy", 403, 344, 236, 1076, 0},
        Known{"landlab_tidal_zSW3.asc", 300, 452, -2.609, 8.461, 35152},
        Known{"landlab_hugo_site.asc", 76, 55, 1660, 1711, 2028}}) {
    CAPTURE(known.name);
    const auto path = test::real_input(std::string("dem/") + known.name);
    if (!path) continue;
    const HeightGrid grid = read_height_grid(*path);
    CHECK(grid.columns == known.columns);
    CHECK(grid.rows == known.rows);
    double low = INFINITY, high = -INFINITY;
    std::size_t without = 0;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const double h = grid.heights[i];
      without += std::isnan(h);
      low = std::fmin(low, h);
      high = std::fmax(high, h);
    }
    CHECK(low == doctest::Approx(known.low).epsilon(1e-3));
    CHECK(high == doctest::Approx(known.high).epsilon(1e-3));
    CHECK(without == known.without);
  }
}

TEST_CASE("of real grids with gaps the domain loses no sample and covers none without data") {
  struct Known {
    const char* name;
    std::size_t corners;
  };
  for (const Known& known :
       {Known{"dem/landlab_tidal_zSW3.asc", 100}, Known{"dem/landlab_hugo_site.asc", 100},
        Known{"nasty/d11_utm_offset_llcenter.asc", 4}}) {
    CAPTURE(known.name);
    const auto path = test::real_input(known.name);
    if (!path) continue;
    const HeightGrid grid = read_height_grid(*path);
    const TerrainDomain domain = terrain_domain(grid);
    CHECK(domain.pslg.points.size() <= known.corners);
    const auto found = test::coverage(grid, constrained_delaunay(domain.pslg).mesh);
    CHECK(found.lost == 0);
    CHECK(found.covered == 0);
  }
}
