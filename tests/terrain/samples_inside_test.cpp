#include "lepp/terrain/samples_inside.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "lepp/terrain/simplify.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/random.hpp"
#include "terrain/coverage.hpp"
#include "terrain/hills.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

// Hills with gaps, and polygons whose corners are samples as often as not.
TerrainDomain random_domain(Random& random, HeightGrid& grid) {
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (random.one_in(9)) grid.heights.set(i, std::numeric_limits<double>::quiet_NaN());
  }
  DomainOptions options;
  const auto place = [&] {
    const Point p{random.real(-3, grid.columns + 2), random.real(-3, grid.rows + 2)};
    const Point sample{std::round(p.x), std::round(p.y)};
    const Point in_grid = random.one_in(2) ? sample : p;
    return grid.to_world({in_grid.x, in_grid.y * grid.aspect()});
  };
  for (int i = 0; i < 2; ++i) {
    ClipPolygon polygon;
    polygon.rings.push_back({place(), place(), place(), place(), place()});
    options.clip.push_back(polygon);
  }
  return terrain_domain(grid, options);
}

}  // namespace

TEST_CASE("samples_inside: those in the triangles of the domain, but for some on its outline") {
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    HeightGrid grid = hills(7 + random.below(30), 7 + random.below(30));
    if (random.one_in(2)) grid.cell_height = random.real(0.3, 3);
    if (random.one_in(2)) grid.step_y = 1;
    const TerrainDomain domain = random_domain(random, grid);
    const SampleSet inside = samples_inside(grid, domain);
    const Mesh mesh = constrained_delaunay(domain.pslg, {.crossings = Crossings::split}).mesh;
    for (std::uint32_t row = 0; row < grid.rows; ++row) {
      for (std::uint32_t column = 0; column < grid.columns; ++column) {
        const Point p = grid.sample(column, grid.row_of_line(row));
        bool in_any = false, on_outline = false;
        for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
          const auto [a, b, c] = mesh.corners(TriangleId(t));
          const int signs[] = {orient2d(b, c, p), orient2d(c, a, p), orient2d(a, b, p)};
          if (std::ranges::min(signs) < 0) continue;
          in_any = true;
          for (std::uint32_t i = 0; i < 3; ++i) {
            on_outline = on_outline || (signs[i] == 0 && mesh.is_boundary({TriangleId(t), i}));
          }
          on_outline = on_outline || std::ranges::count(signs, 0) == 2;  // a corner
        }
        if (on_outline) continue;
        REQUIRE(inside.contains(grid.index(column, row)) == in_any);
      }
    }
  }
}

TEST_CASE("measure_error: with a clip polygon, only samples inside it can be lost") {
  const HeightGrid grid = hills(20, 20);
  const ClipPolygon large{{{{2.5, -2.5}, {16.5, -2.5}, {16.5, -16.5}, {2.5, -16.5}}}};
  const ClipPolygon small{{{{2.5, -2.5}, {14.5, -2.5}, {14.5, -16.5}, {2.5, -16.5}}}};
  const TerrainDomain domain = terrain_domain(grid, {.clip = {large}});
  const SampleSet inside = samples_inside(grid, domain);
  SimplifyReport report;
  const Tin good = simplify(grid, domain, {.max_error = 5}, report);
  CHECK(report.error.lost == 400 - 14 * 14);
  CHECK(measure_error(grid, good, &inside).lost == 0);
  const Tin bad = simplify(grid, terrain_domain(grid, {.clip = {small}}), {.max_error = 5}, report);
  CHECK(measure_error(grid, bad, &inside).lost == 2 * 14);
}
