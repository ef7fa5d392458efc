#include "lepp/terrain/surface_metric.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "lepp/geometry/predicates.hpp"
#include "lepp/terrain/surface_simplify.hpp"
#include "lepp/triangulation/lepp.hpp"
#include "terrain/hills.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

double number(Random& random) { return static_cast<double>(random.below(2001)) / 100 - 10; }

double angle_at(const SpacePoint& apex, const SpacePoint& a, const SpacePoint& b) {
  const SpacePoint u = a - apex, w = b - apex;
  return std::acos(dot(u, w) / std::sqrt(dot(u, u) * dot(w, w))) * 180 / std::numbers::pi;
}

}  // namespace

TEST_CASE("breaks_sphere is a sum of two angles above 180 degrees, the same from either side") {
  Random random(11);
  int broken = 0;
  for (int i = 0; i < 2000; ++i) {
    SpacePoint p[4];
    for (SpacePoint& q : p) q = {number(random), number(random), number(random)};
    const Quad quad{p[0], p[1], p[2], p[3]}, from_beyond{p[1], p[0], p[3], p[2]},
        other_diagonal{p[3], p[2], p[0], p[1]};
    const double sum = angle_at(p[2], p[0], p[1]) + angle_at(p[3], p[0], p[1]);
    if (std::abs(sum - 180) > 1e-4) CHECK(breaks_sphere(quad) == (sum > 180));
    CHECK(breaks_sphere(quad) == breaks_sphere(from_beyond));
    CHECK(!(breaks_sphere(quad) && breaks_sphere(other_diagonal)));
    broken += breaks_sphere(quad) ? 1 : 0;
  }
  CHECK(broken > 100);
}

TEST_CASE(
    "breaks_sphere on a level surface is the circle criterion; four on a circle keep theirs") {
  Random random(12);
  for (int i = 0; i < 2000; ++i) {
    const double z = number(random);
    const Point a{number(random), number(random)}, b{number(random), number(random)};
    const Point c{number(random), number(random)}, d{number(random), number(random)};
    if (orient2d(a, b, c) <= 0 || orient2d(b, a, d) <= 0) continue;
    const Quad quad{{a.x, a.y, z}, {b.x, b.y, z}, {c.x, c.y, z}, {d.x, d.y, z}};
    CHECK(breaks_sphere(quad) == (incircle(a, b, c, d) > 0));
  }
  for (const double tilt : {0.0, 0.75}) {  // any way a square is cut
    const Quad square{{0, 0, 0}, {1, 1, tilt}, {0, 1, 0}, {1, 0, tilt}};
    CHECK(!breaks_sphere(square));
  }
}

TEST_CASE("cos_dihedral: 1 on a plane, 0 on a right angle, -1 folded back") {
  const auto folded = [](double x, double z) {
    return cos_dihedral({{0, 0, 0}, {0, 1, 0}, {-1, 0.5, 0}, {x, 0.5, z}});
  };
  CHECK(folded(1, 0) == 1);
  CHECK(folded(0, 1) == 0);
  CHECK(folded(-1, 0) == -1);
  CHECK(folded(1, std::sqrt(3.0)) == doctest::Approx(0.5));  // 60 degrees
}

TEST_CASE("SlopeMap makes lengths in its plane true, and is undone") {
  const auto on_plane = [](double x, double y) { return SpacePoint{x, y, 3 * x - 0.5 * y + 7}; };
  const std::vector<SpacePoint> chain{on_plane(0, 0), on_plane(4, 1), on_plane(3, 5),
                                      on_plane(-1, 2)};
  const SlopeMap slope(chain);
  for (const SpacePoint& p : chain) {
    for (const SpacePoint& q : chain) {
      CHECK(squared_distance(slope.to_plane(p.plan()), slope.to_plane(q.plan())) ==
            doctest::Approx(squared_distance(p, q)));
    }
    const Point back = slope.to_plan(slope.to_plane(p.plan()));
    CHECK(back.x == doctest::Approx(p.x));
    CHECK(back.y == doctest::Approx(p.y));
  }
  const std::vector<SpacePoint> level{{0, 0, 5}, {4, 0, 5}, {1, 3, 5}};
  CHECK(SlopeMap(level).to_plane({0.3, 0.7}) == Point{0.3, 0.7});
}

TEST_CASE("The longest edge in space: heights count in widths of a cell, ties as in the plane") {
  HeightGrid grid = grid_of(5, 5, [](double x, double) { return x == 4 ? 300 : 0; });
  grid.cell_width = grid.cell_height = 30;  // the cliff is 10 cells high
  TerrainMesh terrain(grid, rectangle(grid));
  const SurfaceMetric metric(terrain);
  CHECK(metric.at(Point{4, 2}).z == doctest::Approx(10));
  for (std::size_t i = 0; i < terrain.mesh().triangle_count(); ++i) {
    const TriangleId t(i);
    CHECK(metric.longest_edge(t) == longest_edge(terrain.mesh(), t));  // the diagonal, still
    CHECK(metric.squared_length(metric.longest_edge(t)) == doctest::Approx(16 + 16 + 100));
  }
  const HeightGrid flat = grid_of(9, 7, [](double, double) { return 3; });
  TerrainMesh level(flat, rectangle(flat));
  const SurfaceMetric plane(level);
  for (std::size_t i = 0; i < level.mesh().triangle_count(); ++i) {
    CHECK(plane.terminal_edge(TriangleId(i)) == terminal_edge(level.mesh(), TriangleId(i)));
  }
}

TEST_CASE("note_angles: an equilateral triangle in space") {
  HeightGrid grid = grid_of(3, 3, [](double, double) { return 0; });
  grid.cell_width = grid.cell_height = 2;
  TerrainDomain domain;
  domain.pslg = polygon({0, 0, 1, 0, 0, 1});
  TerrainMesh terrain(grid, domain);
  Tin tin = terrain.take();
  SurfaceReport report;
  note_angles(grid, tin, 50, report);
  CHECK(report.min_angle_deg == doctest::Approx(45));
  CHECK(report.below_bound == 1);
  // The legs get as long as the hypotenuse.
  for (std::size_t i = 0; i < 3; ++i) {
    if (tin.mesh.point(VertexId(i)) == Point{0, 0}) tin.heights[i] = 2;
  }
  note_angles(grid, tin, 50, report = {});
  CHECK(report.min_angle_deg == doctest::Approx(60));
  CHECK(report.mean_min_angle_deg == doctest::Approx(60));
  CHECK(report.below_bound == 0);
}
