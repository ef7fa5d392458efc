#include "lepp/terrain/terrain_domain.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "lepp/geometry/error.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/random.hpp"
#include "terrain/coverage.hpp"
#include "terrain/grids.hpp"

using namespace lepp;
using test::grid_of;

namespace {

Mesh mesh_of(const HeightGrid& grid) {
  return constrained_delaunay(terrain_domain(grid).pslg).mesh;
}

double area_of(const Mesh& mesh) {
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    area += 0.5 * cross(b - a, c - a);
  }
  return area;
}

HeightGrid random_grid(test::Random& random, double share, double aspect) {
  const std::string empty(2 + random.below(12), '.');
  std::vector<std::string> rows(2 + random.below(12), empty);
  for (std::string& row : rows) {
    for (char& c : row) {
      if (random.real() < share) c = static_cast<char>('0' + random.below(10));
    }
  }
  return grid_of(rows, aspect);
}

}  // namespace

TEST_CASE("a grid with data everywhere is a rectangle of four corners") {
  const HeightGrid grid = grid_of({"1234", "5678", "9012"}, 0.7);
  const TerrainDomain domain = terrain_domain(grid);
  CHECK(domain.pslg.points.size() == 4);
  CHECK(domain.pslg.segments.size() == 4);
  CHECK(area_of(mesh_of(grid)) == doctest::Approx(3 * 2 * 0.7));
}

TEST_CASE("no sample is lost and none without data covered, whatever the pattern") {
  constexpr std::uint64_t seed = 20;
  CAPTURE(seed);
  test::Random random(seed);
  for (int i = 0; i < 1200; ++i) {
    CAPTURE(i);
    const double share = 0.05 + 0.1 * double(random.below(10));
    const HeightGrid grid = random_grid(random, share, i % 3 == 0 ? 1 : i % 3 == 1 ? 0.3 : 1.7);
    if (!grid.has_any_data()) continue;
    const TerrainDomain domain = terrain_domain(grid);
    REQUIRE(validate(domain.pslg).empty());
    const auto found = test::coverage(grid, constrained_delaunay(domain.pslg).mesh);
    REQUIRE(found.lost == 0);
    REQUIRE(found.covered == 0);
  }
}

TEST_CASE(
    "samples alone on a side can be covered without leaving the grid, so that two grids that "
    "share a line of samples never overlap") {
  constexpr std::uint64_t seed = 5;
  CAPTURE(seed);
  test::Random random(seed);
  std::size_t triangles_on_sides = 0;
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    const double share = random.real(0.2, 0.8);
    std::vector<std::string> picture(7, std::string(9, '.'));
    for (std::string& row : picture) {
      for (char& c : row) {
        if (random.real() < share) c = '1';
      }
    }
    picture[0][0] = '1';
    const HeightGrid grid = test::grid_of(picture, i % 3 == 0 ? 1.7 : 1);
    const Pslg pslg = terrain_domain(grid, {.islands_stay_inside = true}).pslg;
    const double north = grid.sample(0, grid.rows - 1).y;
    for (const Point p : pslg.points) {
      REQUIRE(p.x >= 0);
      REQUIRE(p.x <= 8);
      REQUIRE(p.y >= 0);
      REQUIRE(p.y <= north);
      const double line = p.y / grid.aspect();
      const bool on_side = p.x == 0 || p.x == 8 || p.y == 0 || p.y == north;
      if (on_side) REQUIRE((p.x == std::floor(p.x) && line == std::floor(line)));
    }
    const std::size_t plain = terrain_domain(grid).pslg.points.size();
    triangles_on_sides += plain - pslg.points.size();  // three corners in place of four
    const Mesh mesh = constrained_delaunay(pslg).mesh;
    const test::Coverage found = test::coverage(grid, mesh);
    REQUIRE(found.lost == 0);
    REQUIRE(found.covered == 0);
  }
  CHECK(triangles_on_sides > 100);
}
