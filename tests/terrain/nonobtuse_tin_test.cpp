#include "lepp/terrain/nonobtuse_tin.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "lepp/terrain/simplify.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/validate.hpp"
#include "lepp/voronoi/admissible.hpp"
#include "terrain/hills.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

Tin simplified(const HeightGrid& grid, const TerrainDomain& domain, double error) {
  SimplifyReport report;
  SimplifyOptions options;
  options.max_error = error;
  options.by = SimplifyBy::greedy;  // leaves a lot to do
  return simplify(grid, domain, options, report);
}

}  // namespace

TEST_CASE("a TIN becomes nonobtuse and admissible in world coordinates, and keeps its error") {
  HeightGrid grid = rough(50, 40, 11);
  for (std::size_t i = 0; i < grid.size(); ++i) {  // an irregular outline
    const double x = double(i % 50) - 24, y = double(i / 50) - 19;
    if (x * x + 1.5 * y * y > 500) grid.heights.set(i, NAN);
  }
  grid.origin = {500000.1, 4649000.7};  // nothing is exact in the world
  grid.step_x = 6.7218;
  grid.step_y = -6.0591;
  grid.cell_width = grid.step_x;
  grid.cell_height = -grid.step_y;
  const TerrainDomain domain = terrain_domain(grid);
  const double error = 8;
  NonobtuseTinOptions options;
  options.max_error = error;
  Tin before = simplified(grid, domain, error);
  const std::size_t vertices = before.mesh.vertex_count();
  const NonobtuseTin made = make_nonobtuse(grid, std::move(before), options);
  CHECK(made.goal_reached);
  CHECK(made.judged_in_world);
  MeshClaims claims;
  claims.nonobtuse = true;
  claims.min_angle_deg = 30;
  claims.unfinished = made.unfinished;
  CHECK(validate(made.in_world, claims).summary() == "valid");
  CHECK(certify(made.in_world).admissible);
  const TerrainError found = measure_error(grid, made.tin);
  CHECK(found.max <= error + 1e-9);
  CHECK(found.lost == 0);
  CHECK(found.covered == 0);
  CHECK(made.tin.mesh.vertex_count() > vertices);
  CHECK(made.tin.heights.size() == made.in_world.vertex_count());
}

TEST_CASE("in degrees, angles are judged where the cells have their true proportions") {
  HeightGrid grid = hills(30, 30);
  grid.degrees = true;
  grid.step_x = 0.001;
  grid.step_y = -0.001;
  grid.cell_width = 60;
  grid.cell_height = 110;
  const TerrainDomain domain = terrain_domain(grid);
  NonobtuseTinOptions options;
  options.max_error = 5;
  const NonobtuseTin made = make_nonobtuse(grid, simplified(grid, domain, 5), options);
  CHECK(made.goal_reached);
  CHECK_FALSE(made.judged_in_world);
  CHECK(certify(made.tin.mesh).admissible);
  CHECK(made.in_world.point(VertexId(0U)) == grid.to_world(made.tin.mesh.point(VertexId(0U))));
}

TEST_CASE("vertices that cut a line with heights of its own lie on it") {
  const HeightGrid grid = hills(30, 30);
  DomainOptions lines;
  const double ridge = 500;
  lines.breaklines.push_back(
      {{grid.to_world({4, 5}), grid.to_world({25, 21})}, {ridge, ridge}, "dyke"});
  const TerrainDomain domain = terrain_domain(grid, lines);
  NonobtuseTinOptions options;
  options.keep_error = false;  // a dyke is in no error bound
  const NonobtuseTin made = make_nonobtuse(grid, simplified(grid, domain, 20), options);
  std::size_t on_line = 0;
  for (std::size_t i = 0; i < made.tin.mesh.vertex_count(); ++i) {
    const Point p = made.tin.mesh.point(VertexId(i));
    const double distance = std::abs(cross(Point{21, 16}, p - Point{4, 5})) / std::hypot(21, 16);
    if (distance > 1e-6 || p.x < 4 - 1e-6 || p.x > 25 + 1e-6) continue;
    ++on_line;
    CHECK(made.tin.heights[i] == doctest::Approx(ridge));
  }
  CHECK(on_line > 2);
}

TEST_CASE("samples that are inserted on a line with heights of its own do not change it") {
  const HeightGrid grid = rough(20, 20, 5);
  DomainOptions lines;  // through many samples, all far below
  lines.breaklines.push_back({{grid.to_world({2, 9}), grid.to_world({17, 9})}, {500, 500}, "wall"});
  const TerrainDomain domain = terrain_domain(grid, lines);
  NonobtuseTinOptions options;
  options.max_error = 1;
  const NonobtuseTin made = make_nonobtuse(grid, simplified(grid, domain, 1), options);
  CHECK(made.goal_reached);
  const TerrainError found = measure_error(grid, made.tin);
  CHECK(found.max > 300);  // the samples below the wall
  CHECK(found.elsewhere.max <= 1 + 1e-9);
  for (std::size_t i = 0; i < made.tin.mesh.vertex_count(); ++i) {
    const Point p = made.tin.mesh.point(VertexId(i));
    if (p.y != 9 || p.x < 2 || p.x > 17) continue;
    CAPTURE(p.x);
    CHECK(made.tin.heights[i] == doctest::Approx(500));
  }
}

TEST_CASE("heights stay with their places in a TIN that is refined in spatial order") {
  const HeightGrid grid = grid_of(180, 180, [](double x, double y) {  // nearly every sample counts
    return std::fmod(7919 * x + 104729 * y, 97.0);
  });
  const TerrainDomain domain = rectangle(grid);
  NonobtuseTinOptions options;
  options.max_error = 2;
  Tin before = simplified(grid, domain, 2);
  REQUIRE(before.mesh.vertex_count() > 20000);
  const NonobtuseTin made = make_nonobtuse(grid, std::move(before), options);
  CHECK(made.goal_reached);
  CHECK(measure_error(grid, made.tin).max <= 2 + 1e-9);
  CHECK(certify(made.in_world).admissible);
}

TEST_CASE("what is measured are the triangles of the result, also where four are on a circle") {
  HeightGrid grid = grid_of(6, 5, [](double x, double y) { return std::fmod(5 * x + 3 * y, 7.0); });
  grid.origin = {500000.1, 4649000.7};
  grid.step_x = grid.cell_width = 6.7218;
  grid.step_y = -6.0591;
  grid.cell_height = 6.0591;
  const TerrainDomain domain = terrain_domain(grid);
  for (const double error : {0.0, 0.3, 0.6, 1.2, 2.5}) {
    CAPTURE(error);
    NonobtuseTinOptions options;
    options.max_error = error;
    const NonobtuseTin made = make_nonobtuse(grid, simplified(grid, domain, error), options);
    CHECK(made.goal_reached);
    Tin written{made.in_world, made.tin.heights};  // its triangles, back in grid space
    for (std::size_t i = 0; i < written.mesh.vertex_count(); ++i) {
      written.mesh.move_vertex(VertexId(i), made.tin.mesh.point(VertexId(i)));
    }
    CHECK(measure_error(grid, written).max <= error + 1e-9);
  }
}

TEST_CASE("cells that are small beside world coordinates: samples stay what they are") {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    for (const double cell : {0.1, 0.001}) {
      CAPTURE(seed);
      CAPTURE(cell);
      HeightGrid grid = rough(14, 11, seed);
      Random random(seed);
      const double none = std::numeric_limits<double>::quiet_NaN();
      for (std::size_t i = 0; i < grid.size(); ++i) {  // chains of samples, any slope of outlines
        if (random.one_in(2)) grid.heights.set(i, none);
      }
      for (std::uint32_t row = 0; row < 11; ++row) {
        for (std::uint32_t column = 0; column < 14; ++column) {
          if (column + 2 * row > 16) grid.heights.set(grid.index(column, row), 5);
        }
      }
      grid.origin = {500000.37, 4649776.22};
      grid.step_x = grid.cell_width = cell;
      grid.step_y = -cell;
      grid.cell_height = cell;
      const TerrainDomain domain = terrain_domain(grid);
      NonobtuseTinOptions options;  // every sample counts
      const NonobtuseTin made = make_nonobtuse(grid, simplified(grid, domain, 0), options);
      CHECK(made.goal_reached);
      CHECK(validate(made.in_world).summary() == "valid");
      CHECK(certify(made.in_world).admissible);
      CHECK(validate(made.tin.mesh, {.delaunay = false}).valid());
      const TerrainError found = measure_error(grid, made.tin);
      CHECK(found.max <= 1e-6);
      CHECK(found.lost == 0);
      CHECK(found.covered == 0);
    }
  }
}

TEST_CASE("samples on a slanting outline stay inside, whatever its cuts are rounded to") {
  HeightGrid grid = hills(40, 21);
  for (std::uint32_t row = 0; row < 21; ++row) {
    for (std::uint32_t column = 2 * (20 - row); column < 40; ++column) {
      grid.heights.set(grid.index(column, row), std::numeric_limits<double>::quiet_NaN());
    }
  }
  grid.origin = {500000.37, 4649776.22};
  grid.step_x = grid.cell_width = 0.001;
  grid.step_y = -0.001;
  grid.cell_height = 0.001;
  const TerrainDomain domain = terrain_domain(grid);
  NonobtuseTinOptions options;
  options.max_error = 30;
  const NonobtuseTin made = make_nonobtuse(grid, simplified(grid, domain, 30), options);
  CHECK(made.goal_reached);
  CHECK(measure_error(grid, made.tin).lost == 0);
}

TEST_CASE("a line that is off by more than the error does not keep the others from theirs") {
  const HeightGrid grid = grid_of(4, 4, [](double, double) { return 0; });
  DomainOptions lines;
  lines.breaklines.push_back({{{0.5, -0.5}, {2.5, -2.5}}, {50, 50}, "line"});
  const TerrainDomain domain = terrain_domain(grid, lines);
  NonobtuseTinOptions options;
  options.max_error = 1;
  const NonobtuseTin made = make_nonobtuse(grid, simplified(grid, domain, 1), options);
  CHECK(made.goal_reached);
  CHECK(measure_error(grid, made.tin).elsewhere.max <= 1 + 1e-9);
  CHECK(validate(made.tin.mesh).valid());
}
