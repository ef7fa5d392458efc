#include "lepp/terrain/hard_lines.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "lepp/terrain/fit_heights.hpp"
#include "lepp/terrain/nonobtuse_tin.hpp"
#include "lepp/terrain/simplify.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/shapes.hpp"
#include "terrain/hills.hpp"
#include "terrain/plain_error.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

constexpr SimplifyBy both[] = {SimplifyBy::lepp, SimplifyBy::greedy};
const double none = std::numeric_limits<double>::quiet_NaN();

// Nothing about it is exact in the world.
HeightGrid far_hills() {
  HeightGrid grid = hills(41, 41);
  grid.origin = {500000.1, 4649000.7};
  grid.step_x = grid.cell_width = grid.cell_height = 6.7218;
  grid.step_y = -6.7218;
  return grid;
}

struct Line {
  Point a, b;
  double height;
};

TerrainDomain with_lines(const HeightGrid& grid, const std::vector<Line>& lines) {
  DomainOptions options;
  for (const auto& [a, b, height] : lines)
    options.breaklines.push_back({{grid.to_world(a), grid.to_world(b)}, {height, height}, "line"});
  return terrain_domain(grid, options);
}

bool is_on(const Line& line, Point p) {
  const Point d = line.b - line.a;
  const double along = dot(p - line.a, d) / dot(d, d);
  return std::abs(cross(p - line.a, d)) < 1e-4 * std::sqrt(dot(d, d)) && along > -1e-6 &&
         along < 1 + 1e-6;
}

// All vertices on the line, and how many there are.
std::size_t check_heights(const Tin& tin, const Line& line) {
  const std::vector<bool> hard = hard_vertices(tin);
  std::size_t count = 0;
  for (std::size_t i = 0; i < tin.mesh.vertex_count(); ++i) {
    if (!is_on(line, tin.mesh.point(VertexId(i)))) continue;
    ++count;
    CAPTURE(tin.mesh.point(VertexId(i)).x);
    CHECK(tin.heights[i] == doctest::Approx(line.height));
    CHECK(hard[i]);
  }
  return count;
}

// The largest error of samples on none of the lines, by brute force.
double error_beside(const HeightGrid& grid, const Tin& tin, const std::vector<Line>& lines) {
  HeightGrid others = grid;
  for (std::uint32_t line = 0; line < grid.rows; ++line) {
    for (std::uint32_t column = 0; column < grid.columns; ++column) {
      const auto is_there = [&](const Line& l) { return is_on(l, grid.sample(column, line)); };
      if (std::ranges::any_of(lines, is_there))
        others.heights.set(grid.index(column, grid.row_of_line(line)), none);
    }
  }
  return plain_error(others, tin).max;
}

}  // namespace

TEST_CASE("hard lines that leave the grid, and are cut by others, keep their heights") {
  const HeightGrid grid = far_hills();
  const std::vector<Line> lines = {{{-4.3, 20.2}, {36.4, 20.9}, 50}, {{11.7, 3}, {14.9, 49}, 80}};
  DomainOptions options;
  options.clip.push_back({{{grid.to_world({-9, 1.3}), grid.to_world({43, 2.1}),
                            grid.to_world({33.7, 39.4}), grid.to_world({1.9, 44})}}});
  for (const auto& [a, b, height] : lines)
    options.breaklines.push_back({{grid.to_world(a), grid.to_world(b)}, {height, height}, "line"});
  options.breaklines.push_back({{grid.to_world({21.3, 2}), grid.to_world({27.1, 40})}, {}, "soft"});
  // The second line bends to the height of the first one where they cross.
  const Line first = lines[0];
  const TerrainDomain domain = terrain_domain(grid, options);
  for (const double max_error : {4.0, 1000.0}) {
    SimplifyReport report;
    Tin tin = simplify(grid, domain, {.max_error = max_error}, report);
    CHECK(report.goal_reached);
    check_heights(tin, first);
    const NonobtuseTin made = make_nonobtuse(grid, tin, {.max_error = max_error});
    CHECK(made.goal_reached);
    CHECK(check_heights(made.tin, first) >= 5);
    const std::vector<bool> fixed = fixed_vertices(grid, domain, made.tin);
    CHECK(fixed == hard_vertices(made.tin));
    Tin fitted = made.tin;
    fit_heights(grid, fitted, {max_error, fixed});
    check_heights(fitted, first);
  }
}

// Its ends are on lines with heights of their own, but it is on none.
TEST_CASE("the outline between two hard lines is soft, and so is a soft line between them") {
  HeightGrid grid = grid_of(21, 21, [](double, double) { return 0; });
  raise(grid, 10, 20, 9);  // on the southern side
  raise(grid, 10, 10, 9);  // on the soft line
  DomainOptions options;
  for (const double x : {5.0, 15.0})
    options.breaklines.push_back(
        {{grid.to_world({x, -3}), grid.to_world({x, 25})}, {1, 1}, "hard"});
  options.breaklines.push_back({{grid.to_world({5, 10}), grid.to_world({15, 10})}, {}, "soft"});
  const TerrainDomain domain = terrain_domain(grid, options);
  for (const SimplifyBy by : both) {
    SimplifyReport report;
    const Tin tin = simplify(grid, domain, {.max_error = 2, .by = by}, report);
    CHECK(report.goal_reached);
    CHECK(report.error.max <= 2 + 1e-9);
  }
}

TEST_CASE("samples on a hard line may be off by any amount, those beside it may not") {
  const HeightGrid flat = grid_of(21, 21, [](double, double) { return 0; });
  const HeightGrid relief = rough(30, 24, 3);
  const Line along_row{{0, 13}, {13, 13}, -60}, diagonal{{2, 3}, {18, 19}, 90},
      steep{{4, 1}, {12, 17}, 120}, column{{7, 2}, {7, 20}, 80};
  for (const HeightGrid& grid : {flat, relief}) {
    for (const auto& lines : {std::vector{along_row}, std::vector{diagonal}, std::vector{steep},
                              std::vector{column}, std::vector{along_row, diagonal}}) {
      const TerrainDomain domain = with_lines(grid, lines);
      for (int way = 0; way < 4; ++way) {
        CAPTURE(way);
        SimplifyOptions options{.max_error = 3};
        if (way == 0) options.by = SimplifyBy::greedy;
        if (way == 2) options.effort = Effort::best;
        if (way == 3) options.metric = TerrainMetric::surface;
        SimplifyReport report;
        const Tin tin = simplify(grid, domain, options, report);
        CHECK(report.goal_reached);
        CHECK(error_beside(grid, tin, lines) <= 3 + 1e-9);
        CHECK(report.error.max > 3);
        CHECK(report.error.on_hard_lines.max == doctest::Approx(report.error.max));
        CHECK(report.error.elsewhere.max <= 3 + 1e-9);
        if (way != 1) continue;
        const NonobtuseTin made = make_nonobtuse(grid, tin, {.max_error = 3});
        CHECK(made.goal_reached);
        CHECK(error_beside(grid, made.tin, lines) <= 3 + 1e-6);
      }
    }
  }
}

TEST_CASE("a hard line that ends on the outline from outside asks for nothing") {
  const HeightGrid grid = grid_of(9, 9, [](double, double) { return 2; });
  const TerrainDomain domain = with_lines(grid, {{{8, 4}, {12, 4}, 70}, {{1, 1}, {3, 2}, 5}});
  std::size_t asked = 0;
  for (const double h : domain.fixed_heights) {
    CHECK((std::isnan(h) || h == 5));
    asked += std::isnan(h) ? 0 : 1;
  }
  CHECK(asked == 2);
}

TEST_CASE(
    "triangulate_lines: where hard lines cross there is a vertex with the first one's height") {
  Pslg lines = polygon({0, 0, 9, 0, 9, 9, 0, 9});
  add_chain(lines, {{1, 1}, {8, 5}}, false);
  add_chain(lines, {{1, 6.1}, {8, 2.3}}, false);
  const HardTriangulation made = triangulate_lines(lines, {none, none, none, none, 10, 24, 50, 50},
                                                   {false, false, false, false, true, true});
  REQUIRE(made.mesh.vertex_count() == 9);
  CHECK(made.heights[8] == doctest::Approx(10 + 2 * (made.mesh.point(VertexId(8U)).x - 1)));
  CHECK(std::ranges::count(made.hard_segments, true) == 4);
  CHECK(std::ranges::count_if(made.heights, [](double h) { return std::isnan(h); }) == 4);
}

TEST_CASE("samples_on_hard_lines: each once, with the height of the line there") {
  HeightGrid grid = hills(12, 10);
  grid.heights.set(grid.index(5, grid.row_of_line(5)), none);
  const TerrainDomain domain =
      with_lines(grid, {{{2, 2}, {8, 8}, 30}, {{3.5, 0}, {3.5, 9}, 40}, {{1, 7}, {8.5, 7}, 50}});
  SimplifyReport report;
  const Tin tin = simplify(grid, domain, {.max_error = 20}, report);
  std::size_t diagonal = 0, row = 0;
  for (const HardSample& s : samples_on_hard_lines(grid, tin)) {
    const std::uint32_t line = grid.row_of_line(s.row);
    CHECK((s.column == line || line == 7));
    diagonal += s.column == line && line != 7 ? 1 : 0;
    row += line == 7 ? 1 : 0;
    if (s.column <= 3 && s.column == line) CHECK(s.height == doctest::Approx(30));
  }
  CHECK(diagonal == 5);  // 2, 3, 4, 6, 8
  CHECK(row == 8);
  CHECK(report.error.samples_on_hard_lines == 13);
}
