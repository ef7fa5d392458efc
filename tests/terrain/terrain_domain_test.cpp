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
