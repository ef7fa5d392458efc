#include "lepp/terrain/surface_flips.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "terrain/surface_grids.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

constexpr double anything = std::numeric_limits<double>::infinity();

// Four corners with heights of their own, cut along the diagonal that Delaunay takes in plan:
//
//   d(0,4)------c(4,5)     b-d is Delaunay, by a little
//     |           |
//   a(0,0)------b(4,0)
struct Four {
  explicit Four(double height_of_b, double height_of_d, bool keep_diagonal = false)
      : grid(grid_of(5, 6,
                     [&](double x, double row) {
                       if (x == 4 && row == 5) return height_of_b;
                       return x == 0 && row == 1 ? height_of_d : 0.0;
                     })),
        terrain(grid, domain(keep_diagonal)),
        metric(terrain) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (!terrain.mesh().is_boundary({TriangleId(0U), i})) diagonal = {TriangleId(0U), i};
    }
  }
  static TerrainDomain domain(bool keep_diagonal) {
    TerrainDomain d;
    d.pslg = polygon({0, 0, 4, 0, 4, 5, 0, 4});
    if (keep_diagonal) d.pslg.segments.push_back({VertexId(1U), VertexId(3U), {}, 0, 1});
    return d;
  }
  HeightGrid grid;
  TerrainMesh terrain;
  SurfaceMetric metric;
  HalfEdge diagonal;
};

std::size_t flips_of(Four& four, double error, double plan_angle_deg = 15) {
  SurfaceFlips flips(four.metric, four.terrain, plan_angle_deg);
  flips.set_error(error);
  std::vector<HalfEdge> suspects{four.diagonal};
  std::vector<TriangleId> changed;
  flips.restore(suspects, changed);
  return changed.size() / 2;
}

std::optional<KeptBy> only_violation(Four& four, double error, double plan_angle_deg = 15) {
  SurfaceFlips flips(four.metric, four.terrain, plan_angle_deg);
  flips.set_error(error);
  const auto all = flips.violations();
  if (all.size() != 1) return std::nullopt;
  return all.front().kept_by;
}

}  // namespace

TEST_CASE("restore flips a diagonal along which the surface is long, once") {
  Four level(0, 0);
  CHECK(flips_of(level, anything) == 0);
  Four steep(-9, 9);  // b-d is long, a and c see it under wide angles
  CHECK(flips_of(steep, 0) == 1);
  CHECK(flips_of(steep, 0) == 0);
  CHECK(only_violation(steep, 0) == std::nullopt);
  CHECK(validate(steep.terrain.mesh(), {.delaunay = false}).summary() == "valid");
}

TEST_CASE("restore keeps a constrained diagonal, and says so") {
  Four four(-9, 9, true);
  CHECK(flips_of(four, anything) == 0);
  CHECK(only_violation(four, anything) == KeptBy::constraint);
}

TEST_CASE("restore keeps a diagonal where the other would be off by more than may be") {
  Four four(-9, 9);
  // All samples on the planes through a, b, d and through b, c, d.
  for (std::uint32_t row = 0; row < 6; ++row) {
    for (std::uint32_t column = 0; column < 5; ++column) {
      const double x = column, y = 5 - row;
      four.grid.heights.set(four.grid.index(column, row),
                            x + y <= 4 ? 2.25 * (y - x) : 1.8 - 2.7 * x + 1.8 * y);
    }
  }
  std::vector<TriangleId> both{TriangleId(0U), TriangleId(1U)};
  four.terrain.rescan(both);
  const double error = std::max(four.terrain.error(both[0]), four.terrain.error(both[1]));
  CHECK(error < 1e-5);
  CHECK(flips_of(four, 1e-5) == 0);
  CHECK(only_violation(four, 1e-5) == KeptBy::error);
  CHECK(flips_of(four, 100) == 1);
}

TEST_CASE("kept_by_corners: each rule on corners of its own") {
  Four four(0, 0);
  const SurfaceFlips flips(four.metric, four.terrain, 15);
  // c beyond the end a of the edge: not convex in plan, however it is in space
  const Quad dart{{0, 0, 0}, {4, 0, 9}, {-1, 1, 4}, {-1, -1, 4}};
  CHECK(flips.kept_by_corners(dart) == KeptBy::shape);
  // a level square: no gain
  const Quad square{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}};
  CHECK(flips.kept_by_corners(square) == KeptBy::angle);
  // a steep strip: good in space along cd, needles in plan
  const Quad strip{{0, 0, 0}, {1, 0, 60}, {0.5, 5, 30}, {0.5, -5, 30}};
  CHECK(breaks_sphere(strip));
  CHECK(flips.kept_by_corners(strip) == KeptBy::plan_angle);
  CHECK(SurfaceFlips(four.metric, four.terrain, 1).kept_by_corners(strip) == std::nullopt);
}

TEST_CASE("Triangles put aside follow the plan, and go back to the metric of space") {
  Four four(-9, 9);
  REQUIRE(flips_of(four, 0) == 1);
  SurfaceFlips flips(four.metric, four.terrain, 15);
  std::vector<HalfEdge> suspects;
  std::vector<TriangleId> changed;
  const auto diagonal = [&] {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (!four.terrain.mesh().is_boundary({TriangleId(0U), i})) suspects = {{TriangleId(0U), i}};
    }
  };
  flips.set_planar(TriangleId(0U), true);
  diagonal();
  flips.restore(suspects, changed);
  CHECK(changed.size() == 2);
  CHECK(flips.is_planar(TriangleId(1U)));                     // the flip took it along
  CHECK(validate(four.terrain.mesh()).summary() == "valid");  // Delaunay
  flips.clear_planar(suspects);
  CHECK(!flips.any_planar());
  flips.restore(suspects, changed);
  CHECK(changed.size() == 4);
  CHECK(only_violation(four, 0) == std::nullopt);
}
