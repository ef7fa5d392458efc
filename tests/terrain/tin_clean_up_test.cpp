#include "lepp/terrain/tin_clean_up.hpp"

#include <doctest/doctest.h>

#include "lepp/terrain/lepp_loop.hpp"
#include "lepp/terrain/terrain_errors.hpp"
#include "lepp/triangulation/validate.hpp"
#include "terrain/hills.hpp"

using namespace lepp;
using namespace lepp::test;

TEST_CASE("TinCleanUp: vertices go, both bounds stay, and what is frozen stays") {
  const HeightGrid grid = hills(90, 70);
  const auto go_on = [] { return true; };
  for (const double angle : {0.0, 20.0, 30.0}) {
    CAPTURE(angle);
    TerrainMesh terrain(grid, rectangle(grid));
    LeppLoop loop(terrain, angle, go_on);
    loop.run(30, std::numeric_limits<std::size_t>::max());
    loop.freeze();
    const std::vector<Point> coarse(terrain.mesh().points().begin(), terrain.mesh().points().end());
    loop.run(4, std::numeric_limits<std::size_t>::max());
    const std::size_t before = terrain.mesh().vertex_count();
    TinCleanUp clean_up(terrain, angle, 4, coarse.size(), go_on);
    const std::size_t removed = clean_up.remove_needless(), merged = clean_up.merge();
    CHECK(removed > 0);
    CHECK(merged > 0);
    CHECK(terrain.mesh().vertex_count() == before - removed - merged);
    loop.run(4, std::numeric_limits<std::size_t>::max());  // corners on a circle
    CHECK(terrain.mesh().vertex_count() <= before - (removed + merged) / 2);
    CHECK(largest_error(terrain) <= 4);
    CHECK(validate(terrain.mesh(), {.min_angle_deg = angle}).summary() == "valid");
    CHECK(std::equal(coarse.begin(), coarse.end(), terrain.mesh().points().begin()));
    CHECK(measure_error(grid, terrain.tin()).max == doctest::Approx(largest_error(terrain)));
  }
}
