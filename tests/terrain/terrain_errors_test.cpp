#include "lepp/terrain/terrain_errors.hpp"

#include <doctest/doctest.h>

#include "terrain/hills.hpp"

using namespace lepp;
using namespace lepp::test;

TEST_CASE("terrain errors: of all triangles, of those above a limit, and what is given up") {
  const HeightGrid grid = hills(20, 16);
  const TerrainMesh terrain(grid, rectangle(grid));
  const double largest = largest_error(terrain);
  CHECK(largest == doctest::Approx(measure_error(grid, terrain.tin()).max));
  ErrorHeap heap = errors_above(terrain, 1);
  CHECK(heap.size() == 2);
  CHECK(heap.top_error() == largest);
  CHECK(largest_error(terrain, heap) == largest);
  heap.set(TriangleId(0U), 0);
  heap.set(TriangleId(1U), 0);
  CHECK(largest_error(terrain, heap) == 1);
  CHECK(errors_above(terrain, largest).size() == 0);
}

TEST_CASE("error_of_star: what a vertex makes of the errors, before it is there") {
  const HeightGrid grid = hills(20, 16);
  TerrainMesh terrain(grid, rectangle(grid));
  std::vector<TriangleId> changed;
  REQUIRE(terrain.insert_inside(TriangleId(0U), {9, 6}, changed));
  terrain.rescan(changed);
  Star star;
  REQUIRE(find_star(terrain.mesh(), changed[0], 0, star));
  const double before = largest_error(terrain, star);
  CHECK(before == largest_error(terrain));
  CHECK(error_of_star(terrain, star, {9, 6}) == before);
  const Point elsewhere{7, 8};
  const double expected = error_of_star(terrain, star, elsewhere);
  terrain.mesh().move_vertex(VertexId(4U), elsewhere);
  terrain.set_height(VertexId(4U));
  terrain.rescan_all();
  CHECK(expected != before);
  CHECK(largest_error(terrain, star) == expected);
}
