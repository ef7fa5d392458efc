#include "lepp/terrain/join_tins.hpp"

#include <doctest/doctest.h>

#include "lepp/terrain/grid_part.hpp"
#include "lepp/terrain/simplify.hpp"
#include "lepp/terrain/tile_border.hpp"
#include "lepp/triangulation/validate.hpp"
#include "terrain/hills.hpp"

using namespace lepp;

namespace {

// A window of a grid, with its four sides fixed.
Tin tile_of(const HeightGrid& whole, const GridWindow& window, SimplifyOptions options) {
  GridPart part = part_of(whole, window);
  const BorderCorners corners = border_corners(part);
  leave_to_neighbours(part);
  TerrainDomain domain = terrain_domain(part.grid);
  fix_borders(part.grid, 4, domain, corners);
  SimplifyReport report;
  return simplify(part.grid, domain, options, report);
}

Point shift_of(const HeightGrid& whole, const GridWindow& window) {
  const std::uint32_t line = whole.rows - window.row - window.rows;
  return {double(window.column), line * whole.aspect()};
}

std::size_t outline_edges(const Mesh& mesh) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdge e{TriangleId(i), k};
      if (mesh.is_boundary(e)) CHECK(mesh.curve_of(e) == CurveId(0U));
      count += mesh.is_boundary(e);
      if (mesh.is_constrained(e)) CHECK(mesh.is_boundary(e));
    }
  }
  return count;
}

}  // namespace

TEST_CASE("tiles join to one valid mesh with the outline of the whole and its groups") {
  HeightGrid grid = test::hills(41, 31);
  for (std::uint32_t row = 10; row < 19; ++row) {  // a hole across the line that tiles share
    for (std::uint32_t column = 15; column < 28; ++column) {
      grid.heights.set(grid.index(column, row), std::numeric_limits<double>::quiet_NaN());
    }
  }
  grid.cell_height = 1.3;
  for (const SimplifyBy by : {SimplifyBy::lepp, SimplifyBy::greedy}) {
    JoinedTin joined;
    std::size_t vertices = 0;
    for (const GridWindow& window :
         {GridWindow{0, 0, 21, 16}, {20, 0, 21, 16}, {0, 15, 21, 16}, {20, 15, 21, 16}}) {
      const Tin tile = tile_of(grid, window, {.max_error = 4, .by = by});
      vertices += tile.mesh.vertex_count();
      joined.add(tile, shift_of(grid, window));
    }
    const Tin tin = joined.join("tiles");
    CHECK(tin.mesh.vertex_count() < vertices);
    CHECK(tin.heights.size() == tin.mesh.vertex_count());
    CHECK(validate(tin.mesh, {.delaunay = false}).summary() == "valid");
    CHECK(tin.mesh.entities().groups.size() == 2);
    CHECK(outline_edges(tin.mesh) > 4);
    const TerrainError error = measure_error(grid, tin);
    CHECK(error.max <= 4 + 1e-9);
    CHECK(error.lost == 0);
    CHECK(error.covered == 0);
  }
}

TEST_CASE("no tile is no TIN, and tiles that overlap are refused") {
  CHECK_THROWS(JoinedTin().join("none"));
  const HeightGrid grid = test::hills(9, 9);
  const Tin tile = tile_of(grid, {0, 0, 9, 9}, {.max_error = 4});
  JoinedTin twice;
  twice.add(tile);
  twice.add(tile);
  CHECK_THROWS(twice.join("twice"));
}
