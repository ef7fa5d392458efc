#include "lepp/terrain/world_tin.hpp"

#include <doctest/doctest.h>

#include "support/hand_made.hpp"

using namespace lepp;

TEST_CASE("a TIN in the world: rows go south, and lines of grid space north") {
  HeightGrid grid;
  grid.columns = 3;
  grid.rows = 2;
  for (const int height : {1, 2, 3, 4, 5, 6}) grid.heights.push_back(height);
  grid.origin = {100, 50};
  grid.step_x = 10;
  grid.step_y = -20;
  grid.cell_width = 10;
  grid.cell_height = 20;
  grid.source = "folder/dem.asc";
  Tin tin{test::from_triangles({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{0, 1, 2}, {0, 2, 3}}),
          {4, 6, 3, 1}};
  const WorldTin world = to_world(tin, grid);
  CHECK(world.mesh.point(VertexId(0U)) == Point{100, 30});
  CHECK(world.mesh.point(VertexId(2U)) == Point{120, 50});
  CHECK(world.title == "dem.asc");
  grid.step_y = 20;
  CHECK(to_world(tin, grid).mesh.point(VertexId(0U)) == Point{100, 50});
}
