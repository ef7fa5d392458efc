#include "lepp/terrain/simplify.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "lepp/geometry/error.hpp"
#include "lepp/triangulation/validate.hpp"
#include "terrain/hills.hpp"
#include "terrain/plain_error.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

// What is promised of every result.
void check_promises(const HeightGrid& grid, const Tin& tin, const SimplifyOptions& options,
                    const SimplifyReport& report) {
  CHECK(report.goal_reached);
  CHECK(tin.heights.size() == tin.mesh.vertex_count());
  CHECK(report.error.max <= options.max_error * (1 + 1e-9) + 1e-9);
  CHECK(report.error.lost == 0);
  CHECK(report.error.covered == 0);
  CHECK(report.levels.back().vertices == tin.mesh.vertex_count());
  CHECK(report.levels.back().max_error == report.error.max);
  CHECK(measure_error(grid, tin).max == report.error.max);
  MeshClaims claims;
  if (options.by == SimplifyBy::lepp) {
    claims.min_angle_deg = options.min_angle_deg;
    claims.unfinished = report.unfinished;
  }
  CHECK(validate(tin.mesh, claims).summary() == "valid");
}

constexpr SimplifyBy both[] = {SimplifyBy::greedy, SimplifyBy::lepp};

}  // namespace

TEST_CASE("simplify keeps its bounds on hills, on cliffs with noise, in cells of any shape") {
  for (const SimplifyBy by : both) {
    for (const double aspect : {1.0, 0.7, 1.3}) {
      for (const double bound : {25.0, 4.0}) {
        CAPTURE(aspect);
        CAPTURE(bound);
        for (HeightGrid grid : {hills(60, 45), rough(40, 52, 7)}) {
          grid.cell_height = aspect;
          SimplifyOptions options{.max_error = bound, .by = by};
          SimplifyReport report;
          const Tin tin = simplify(grid, rectangle(grid), options, report);
          check_promises(grid, tin, options, report);
        }
      }
    }
  }
}

TEST_CASE("simplify: the error found is the error by brute force") {
  const HeightGrid grid = rough(40, 30, 9);
  SimplifyReport report;
  const Tin tin =
      simplify(grid, rectangle(grid), {.max_error = 9, .by = SimplifyBy::greedy}, report);
  CHECK(report.error.max == doctest::Approx(plain_error(grid, tin).max));
  CHECK(report.error_of_prefix.size() == tin.mesh.vertex_count() - report.first_prefix + 1);
  CHECK(report.error_of_prefix.back() == report.error.max);
}

TEST_CASE("simplify: a bound of 0 ends with every sample represented") {
  for (const SimplifyBy by : both) {
    const HeightGrid grid = rough(17, 14, 1);
    SimplifyOptions options{.by = by};
    SimplifyReport report;
    const Tin tin = simplify(grid, rectangle(grid), options, report);
    check_promises(grid, tin, options, report);
  }
}

TEST_CASE("simplify: a plane, and a flat grid, need no vertex but the domain's") {
  for (const SimplifyBy by : both) {
    for (const double steep : {0.0, 2.5}) {
      const HeightGrid grid = grid_of(30, 20, [&](double x, double y) { return steep * (x - y); });
      SimplifyOptions options{.by = by};
      SimplifyReport report;
      CHECK(simplify(grid, rectangle(grid), options, report).mesh.vertex_count() == 4);
      CHECK(report.goal_reached);
    }
  }
}

TEST_CASE("simplify: levels are prefixes of one another, with the error that was found for each") {
  for (const SimplifyBy by : both) {
    const HeightGrid grid = hills(70, 50);
    std::vector<Tin> tins;
    SimplifyOptions options{.max_error = 2, .by = by};
    options.level_errors = {40, 10};
    options.on_level = [&](const Tin& tin, const TerrainLevel& level) {
      CHECK(level.vertices == tin.mesh.vertex_count());
      CHECK(level.max_error == measure_error(grid, tin).max);
      tins.push_back(tin);
    };
    SimplifyReport report;
    tins.push_back(simplify(grid, rectangle(grid), options, report));
    REQUIRE(tins.size() == 3);
    REQUIRE(report.levels.size() == 3);
    CHECK(report.levels[0].max_error <= 40);
    CHECK(report.levels[1].max_error <= 10);
    for (std::size_t level = 0; level + 1 < tins.size(); ++level) {
      const auto points = tins[level].mesh.points(), next = tins[level + 1].mesh.points();
      REQUIRE(points.size() < next.size());
      CHECK(std::equal(points.begin(), points.end(), next.begin()));
      CHECK(std::equal(tins[level].heights.begin(), tins[level].heights.end(),
                       tins[level + 1].heights.begin()));
    }
  }
}

TEST_CASE("simplify: a TIN that reaches several levels at once is each of them") {
  const HeightGrid flat = test::grid_of(30, 20, [](double, double) { return 7; });
  const HeightGrid uneven = hills(70, 50);
  for (const SimplifyBy by : both) {
    SimplifyOptions options{.max_error = 2, .by = by};
    options.level_errors = {500, 400, 300, 20};
    std::size_t levels = 0;
    options.on_level = [&](const Tin&, const TerrainLevel&) { ++levels; };
    SimplifyReport report;
    simplify(uneven, rectangle(uneven), options, report);
    CHECK(levels == 4);
    REQUIRE(report.levels.size() == 5);
    CHECK(report.levels[0].vertices == report.levels[2].vertices);
    CHECK(report.levels[2].vertices < report.levels[3].vertices);
    CHECK(report.levels[3].max_error <= 20);
    simplify(flat, rectangle(flat), options, report);
    CHECK(report.levels.size() == 5);
    options.level_errors = {3};
    options.level_vertices = {100, 200};
    options.max_vertices = 300;
    simplify(flat, rectangle(flat), options, report);
    CHECK(report.levels.size() == 4);
  }
}

TEST_CASE("simplify: each level lists its triangles below the bound, with the same reasons") {
  const HeightGrid grid = hills(25, 6);
  SimplifyOptions options{.max_vertices = 150, .level_vertices = {6, 20, 60}};
  std::size_t listed = 0;
  options.on_level = [&](const Tin& tin, const TerrainLevel& level) {
    listed += level.unfinished.size();
    for (const Unfinished& u : level.unfinished) CHECK(u.reason == Reason::budget);
    MeshClaims claims;
    claims.min_angle_deg = options.min_angle_deg;
    claims.unfinished = level.unfinished;
    CHECK(validate(tin.mesh, claims).summary() == "valid");
  };
  SimplifyReport report;
  simplify(grid, rectangle(grid), options, report);
  CHECK(listed > 0);
  CHECK(report.levels.back().unfinished == report.unfinished);
}

TEST_CASE("simplify: levels say which counts they were asked for, and exceed them if they must") {
  const HeightGrid grid = hills(20, 15);
  SimplifyOptions options{.max_vertices = 100, .level_errors = {500}, .level_vertices = {3, 50}};
  SimplifyReport report;
  simplify(grid, rectangle(grid), options, report);
  REQUIRE(report.levels.size() == 4);
  CHECK(!report.levels[0].most_vertices);
  CHECK(report.levels[1].most_vertices == 3U);
  CHECK(report.levels[1].vertices == 4);
  CHECK(report.levels[2].most_vertices == 50U);
  CHECK(!report.levels[3].most_vertices);
}

TEST_CASE("simplify: a bound on vertices is kept, and levels end at their counts") {
  const HeightGrid grid = hills(70, 50);
  for (const SimplifyBy by : both) {
    const SimplifyOptions options{.max_vertices = 120, .by = by, .level_vertices = {20, 60}};
    SimplifyReport report;
    const Tin tin = simplify(grid, rectangle(grid), options, report);
    REQUIRE(report.levels.size() == 3);
    CHECK(report.levels[2].vertices == tin.mesh.vertex_count());
    const std::size_t counts[] = {20, 60, 120};
    const std::size_t free = by == SimplifyBy::greedy ? 0 : 5;  // angles may ask for more than one
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(report.levels[i].vertices <= counts[i]);
      CHECK(report.levels[i].vertices + free >= counts[i]);
    }
    CHECK(!report.goal_reached);  // the error asked for was 0
  }
}

TEST_CASE("simplify: where angles alone take more vertices than there may be, they stay small") {
  const HeightGrid level = grid_of(200, 9, [](double, double) { return 5; });
  SimplifyReport report;
  const std::size_t needed = simplify(level, rectangle(level), {}, report).mesh.vertex_count();
  REQUIRE(needed > 15);
  CHECK(simplify(level, rectangle(level), {.max_vertices = needed}, report).mesh.vertex_count() <=
        needed);
  CHECK(report.goal_reached);
  for (const std::size_t most : {4U, 5U, 11U, 15U}) {
    CAPTURE(most);
    const Tin tin = simplify(level, rectangle(level), {.max_vertices = most}, report);
    CHECK(tin.mesh.vertex_count() <= most);
    CHECK(tin.mesh.vertex_count() + 3 > most);
    CHECK_FALSE(report.goal_reached);
    CHECK(std::ranges::all_of(report.unfinished,
                              [](const Unfinished& u) { return u.reason == Reason::budget; }));
    MeshClaims claims;
    claims.min_angle_deg = 30;
    claims.unfinished = report.unfinished;
    CHECK(validate(tin.mesh, claims).summary() == "valid");
  }
}

TEST_CASE("simplify: a domain of more vertices than there may be leaves the goal unreached") {
  const HeightGrid grid = grid_of(30, 30, [](double, double) { return 5; });
  TerrainDomain domain;
  domain.pslg = polygon({0, 0, 10, 3, 29, 0, 26, 10, 29, 29, 12, 26, 0, 29});
  for (const SimplifyBy by : both) {
    SimplifyReport report;
    const Tin tin = simplify(grid, domain, {.max_vertices = 6, .by = by}, report);
    CHECK_FALSE(report.goal_reached);
    CHECK(report.first_prefix == 7);
    CHECK(tin.mesh.vertex_count() == 7);
  }
}

TEST_CASE("simplify: the same bytes on every run") {
  const HeightGrid grid = rough(50, 40, 2);
  for (const SimplifyBy by : both) {
    SimplifyReport first_report, second_report;
    const SimplifyOptions options{.max_error = 6, .by = by};
    const Tin first = simplify(grid, rectangle(grid), options, first_report);
    const Tin second = simplify(grid, rectangle(grid), options, second_report);
    CHECK(std::ranges::equal(first.mesh.points(), second.mesh.points()));
    CHECK(first.heights == second.heights);
    CHECK(std::ranges::equal(
        first.mesh.triangles(), second.mesh.triangles(),
        [](const Triangle& a, const Triangle& b) { return a.vertices == b.vertices; }));
  }
}

TEST_CASE("simplify: samples without data outside the domain ask for nothing") {
  HeightGrid grid = hills(40, 30);
  for (std::uint32_t row = 0; row < 30; ++row) {
    for (std::uint32_t column = 20; column < 40; ++column) {
      grid.heights.set(grid.index(column, row), NAN);
    }
  }
  TerrainDomain domain;
  domain.pslg = polygon({0, 0, 19, 0, 19, 29, 0, 29});
  for (const SimplifyBy by : both) {
    SimplifyOptions options{.max_error = 5, .by = by};
    SimplifyReport report;
    const Tin tin = simplify(grid, domain, options, report);
    check_promises(grid, tin, options, report);
    CHECK(report.error.samples == 20 * 30);
  }
}

TEST_CASE("simplify: a hard line keeps its heights, also where it is cut") {
  const HeightGrid grid = hills(40, 30);
  TerrainDomain domain = rectangle(grid);
  add_chain(domain.pslg, {{5.5, 6.25}, {33.25, 21.5}}, false);
  domain.fixed_heights.assign(6, std::numeric_limits<double>::quiet_NaN());
  domain.fixed_heights[4] = 100;
  domain.fixed_heights[5] = 200;
  domain.hard_segments = {false, false, false, false, true};
  for (const SimplifyBy by : both) {
    SimplifyReport report;
    const Tin tin = simplify(grid, domain, {.max_error = 5, .by = by}, report);
    CHECK(validate(tin.mesh).summary() == "valid");
    std::size_t on_line = 0;
    for (std::size_t i = 0; i < tin.mesh.vertex_count(); ++i) {
      const Point p = tin.mesh.point(VertexId(i)), a{5.5, 6.25}, d{27.75, 15.25};
      const double along = dot(p - a, d) / dot(d, d);
      if (std::abs(cross(p - a, d)) > 1e-9 || along < 0 || along > 1) continue;
      ++on_line;
      CHECK(tin.heights[i] == doctest::Approx(100 + 100 * along));
    }
    CHECK(on_line >= 2);
  }
}

TEST_CASE("simplify: a kept border is not cut") {
  const HeightGrid grid = hills(40, 30);
  TerrainDomain domain = rectangle(grid);
  domain.kept_border.assign(4, true);
  for (const SimplifyBy by : both) {
    SimplifyReport report;
    const Tin tin = simplify(grid, domain, {.max_error = 5, .by = by}, report);
    std::size_t on_border = 0;
    for (const Point p : tin.mesh.points()) {
      on_border += p.x == 0 || p.y == 0 || p.x == 39 || p.y == 29 ? 1 : 0;
    }
    CHECK(on_border == 4);
    CHECK(!report.goal_reached);  // the border itself is off by more
    CHECK(validate(tin.mesh).summary() == "valid");
    for (const Unfinished& u : report.unfinished) CHECK(u.reason == Reason::kept_border);
  }
}

TEST_CASE("simplify refuses options out of range") {
  const HeightGrid grid = hills(10, 10);
  SimplifyReport report;
  const auto run = [&](const SimplifyOptions& options) {
    return simplify(grid, rectangle(grid), options, report);
  };
  CHECK_THROWS_AS(run({.max_error = -1}), InputError);
  CHECK_THROWS_AS(run({.min_angle_deg = 35}), InputError);
  CHECK_THROWS_AS(run({.max_error = 5, .level_errors = {10, 20}}), InputError);
  CHECK_THROWS_AS(run({.max_error = 5, .level_errors = {4}}), InputError);
  CHECK_THROWS_AS(run({.level_vertices = {20, 10}}), InputError);
}

TEST_CASE("simplify: relief that the metric of the surface cannot compare with cells is refused") {
  HeightGrid grid = grid_of(5, 4, [](double x, double y) { return x * y; });
  SimplifyReport report;
  SimplifyOptions options{.max_error = 1};
  options.metric = TerrainMetric::surface;
  CHECK_NOTHROW(simplify(grid, terrain_domain(grid), options, report));
  grid.heights.set(7, -3.4e38);
  CHECK_THROWS_AS(simplify(grid, terrain_domain(grid), options, report), InputError);
  options.metric = TerrainMetric::planar;
  CHECK_NOTHROW(simplify(grid, terrain_domain(grid), options, report));
}
