#include "lepp/terrain/surface_star.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "lepp/triangulation/locate.hpp"
#include "terrain/surface_grids.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

// What the star of `v` is really like.
struct Found {
  double in_space = 0, in_plan = 0;
  std::size_t triangles = 0;
};

Found star_of(const TerrainMesh& terrain, const SurfaceMetric& metric, VertexId v) {
  Found found;
  for_each_in_fan(terrain.mesh(), v, [&](TriangleId t, std::uint32_t) {
    const auto [a, b, c] = terrain.mesh().corners(t);
    found.in_space = std::max(found.in_space, metric.badness(t));
    found.in_plan = std::max(found.in_plan, AngleTest::badness(a, b, c));
    ++found.triangles;
  });
  return found;
}

}  // namespace

TEST_CASE("SurfaceStar: the star that grows is the star that is filled, in space and in plan") {
  for (const TerrainMetric kind : {TerrainMetric::surface, TerrainMetric::planar}) {
    for (const HeightGrid& grid : {steep_hills(40, 30), wild(40, 30, 5)}) {
      TerrainMesh terrain(grid, rectangle(grid));
      const SurfaceMetric metric(terrain);
      SurfaceFlips flips(metric, terrain, 15);
      SurfaceStar star(metric, flips, terrain);
      Random random(3);
      std::vector<TriangleId> changed;
      int filled = 0;
      for (int i = 0; i < 150; ++i) {
        const Point p{double(random.below(39)), double(random.below(29))};
        if (!star.grow(locate(terrain.mesh(), p)->triangle, p, kind)) continue;
        changed.clear();
        star.fill(changed);
        const VertexId v(terrain.mesh().vertex_count() - 1);
        const Found found = star_of(terrain, metric, v);
        CHECK(found.triangles == star.rim().size());
        CHECK(found.in_space == star.badness_in_space());
        CHECK(found.in_plan == star.badness_in_plan());
        ++filled;
      }
      CHECK(filled > 80);
      const bool planar = kind == TerrainMetric::planar;
      CHECK(validate(terrain.mesh(), {.delaunay = planar}).summary() == "valid");
    }
  }
}

TEST_CASE("SurfaceStar: on level ground both metrics grow the same star") {
  const HeightGrid grid = grid_of(30, 30, [](double, double) { return 4; });
  TerrainMesh terrain(grid, rectangle(grid));
  const SurfaceMetric metric(terrain);
  SurfaceFlips flips(metric, terrain, 15);
  SurfaceStar star(metric, flips, terrain);
  Random random(8);
  std::vector<TriangleId> changed;
  for (int i = 0; i < 100; ++i) {
    const Point p{double(random.below(2900)) / 100, double(random.below(2900)) / 100};
    const TriangleId t = locate(terrain.mesh(), p)->triangle;
    if (!star.grow(t, p, TerrainMetric::planar)) continue;
    std::vector<HalfEdge> plan, space;
    for (const auto& e : star.rim()) plan.push_back(e.inside);
    const double badness = star.badness_in_plan();
    REQUIRE(star.grow(t, p, TerrainMetric::surface));
    for (const auto& e : star.rim()) space.push_back(e.inside);
    CHECK(plan == space);
    CHECK(star.badness_in_space() == badness);
    star.fill(changed);
  }
  CHECK(terrain.mesh().vertex_count() > 60);
}

TEST_CASE("SurfaceStar: no star at a vertex or on a constrained edge") {
  const HeightGrid grid = hills(20, 20);
  TerrainMesh terrain(grid, rectangle(grid));
  const SurfaceMetric metric(terrain);
  SurfaceFlips flips(metric, terrain, 15);
  SurfaceStar star(metric, flips, terrain);
  const auto grows = [&](Point p) {
    return star.grow(locate(terrain.mesh(), p)->triangle, p, TerrainMetric::surface);
  };
  CHECK(!grows({0, 0}));
  CHECK(!grows({7, 0}));
  CHECK(grows({7, 1}));
  CHECK(star.encroached().has_value());
  CHECK(grows({9, 9}));  // on the diagonal
}

TEST_CASE("SurfaceStar: tame means hardly folded, and shorter edges") {
  // a level place, but for a spike
  const HeightGrid grid =
      grid_of(21, 21, [](double x, double y) { return x == 8 && y == 12 ? 200 : 0; });
  TerrainMesh terrain(grid, rectangle(grid));
  const SurfaceMetric metric(terrain);
  SurfaceFlips flips(metric, terrain, 15);
  SurfaceStar star(metric, flips, terrain);
  const auto grow = [&](Point p) {
    REQUIRE(star.grow(locate(terrain.mesh(), p)->triangle, p, TerrainMetric::surface));
  };
  grow({10, 10});
  CHECK(star.is_tame());
  grow({8, 8});  // line 8 is row 12: the spike
  CHECK(!star.is_tame());
  std::vector<TriangleId> changed;
  star.fill(changed);
  grow({4, 4});  // on the edge between two flanks of the spike
  CHECK(!star.is_tame());
}
