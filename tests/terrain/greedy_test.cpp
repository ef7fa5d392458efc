#include "lepp/terrain/greedy.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "lepp/terrain/terrain_errors.hpp"
#include "terrain/hills.hpp"
#include "terrain/plain_error.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

// A line through `points`; heights of NaN ask for nothing.
void add_line(TerrainDomain& domain, const std::vector<Point>& points,
              const std::vector<double>& heights) {
  domain.fixed_heights.resize(domain.pslg.points.size(), std::numeric_limits<double>::quiet_NaN());
  add_chain(domain.pslg, points, false);
  domain.fixed_heights.insert(domain.fixed_heights.end(), heights.begin(), heights.end());
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    domain.hard_segments.resize(domain.pslg.segments.size() - (heights.size() - 1) + i);
    domain.hard_segments.push_back(!std::isnan(heights[i]) && !std::isnan(heights[i + 1]));
  }
}

// Each prefix is what a run that ends with so many vertices makes, and is off by what is said.
std::size_t check_prefixes(const HeightGrid& grid, const TerrainDomain& domain, double max_error) {
  SimplifyReport whole;
  const Tin tin = simplify(grid, domain, {.max_error = max_error, .by = SimplifyBy::greedy}, whole);
  REQUIRE(whole.error_of_prefix.size() == tin.mesh.vertex_count() - whole.first_prefix + 1);
  for (std::size_t i = 0; i < whole.error_of_prefix.size(); ++i) {
    CAPTURE(i);
    SimplifyReport report;
    const Tin part = simplify(
        grid, domain, {.max_vertices = whole.first_prefix + i, .by = SimplifyBy::greedy}, report);
    const auto first = part.mesh.points();
    REQUIRE(first.size() == whole.first_prefix + i);
    CHECK(std::equal(first.begin(), first.end(), tin.mesh.points().begin()));
    CHECK(whole.error_of_prefix[i] == doctest::Approx(measure_error(grid, part).max).epsilon(1e-9));
    CHECK(report.error_of_prefix.back() == report.error.max);
  }
  return whole.error_of_prefix.size();
}

}  // namespace

TEST_CASE("greedy: the error of every prefix is that of the TIN with so many vertices") {
  CHECK(check_prefixes(hills(17, 14), rectangle(hills(17, 14)), 5) > 20);
  HeightGrid grid = rough(13, 12, 3);
  CHECK(check_prefixes(grid, rectangle(grid), 0) > 80);
  grid.cell_height = 0.7;
  grid.heights.set(grid.index(5, 5), NAN);
  CHECK(check_prefixes(grid, rectangle(grid), 8) > 10);
}

TEST_CASE("greedy: errors of prefixes where triangles are given up beside hard lines") {
  const HeightGrid flat = grid_of(21, 21, [](double, double) { return 0; });
  TerrainDomain along_row = rectangle(flat);
  add_line(along_row, {{0, 13}, {13, 13}}, {-6, 0});
  CHECK(check_prefixes(flat, along_row, 1) >= 1);

  const HeightGrid grid = hills(20, 16);
  TerrainDomain across = rectangle(grid);
  add_line(across, {{2, 3}, {8, 6}, {14.5, 12.25}}, {5, 20, -10});
  CHECK(check_prefixes(grid, across, 4) > 10);

  TerrainDomain small_at_line = rectangle(grid);  // the line is off by less than others for long
  add_line(small_at_line, {{4, 5}, {10, 5}}, {hill(4, 10) + 9, hill(10, 10) + 9});
  CHECK(check_prefixes(grid, small_at_line, 1) > 10);
}

TEST_CASE("greedy: errors of prefixes where a border stays whole") {
  const HeightGrid grid = hills(20, 16);
  TerrainDomain domain = rectangle(grid);
  domain.kept_border.assign(4, true);
  CHECK(check_prefixes(grid, domain, 3) > 10);
}

TEST_CASE("error_at_lines: samples at vertices and on hard lines, of any direction") {
  const HeightGrid grid = grid_of(12, 12, [](double x, double y) { return x == y ? 9 : 0; });
  const auto found = [&](const std::vector<Point>& points, const std::vector<double>& heights) {
    TerrainDomain domain = rectangle(grid);
    add_line(domain, points, heights);
    return error_at_lines(TerrainMesh(grid, domain));
  };
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  CHECK(found({{0.5, 3}, {7.5, 3}}, {1, 1}) == 1);     // row 8, where x is 1 to 7
  CHECK(found({{0.5, 3}, {8.5, 3}}, {1, 1}) == 8);     // and 8
  CHECK(found({{3, 0.5}, {3, 8.5}}, {-1, -1}) == 10);  // a column
  CHECK(found({{1, 1}, {9, 5}}, {4, 0}) == 8);         // (7, 4), where the line is at 1
  CHECK(found({{9, 5}, {1, 1}}, {0, 4}) == 8);
  CHECK(found({{0.5, 3.5}, {7.5, 3.75}}, {1, 1}) == 0);  // between samples
  CHECK(found({{1, 1}, {9, 5}}, {none, none}) == 0);
  CHECK(found({{1, 1}, {9, 5}}, {none, 3}) == 3);  // a vertex alone
}
