#include "lepp/terrain/surface_simplify.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "lepp/geometry/error.hpp"
#include "lepp/terrain/surface_loop.hpp"
#include "terrain/plain_error.hpp"
#include "terrain/surface_grids.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

bool are_equal(const Tin& a, const Tin& b) {
  return std::ranges::equal(a.mesh.points(), b.mesh.points()) && a.heights == b.heights &&
         std::ranges::equal(
             a.mesh.triangles(), b.mesh.triangles(),
             [](const Triangle& s, const Triangle& t) { return s.vertices == t.vertices; });
}

Tin run(const HeightGrid& grid, const TerrainDomain& domain, SimplifyOptions options,
        TerrainMetric metric, SimplifyReport& report) {
  options.metric = metric;
  return simplify(grid, domain, options, report);
}

// On level ground both metrics make the same TIN, of so many vertices more than the domain has.
std::size_t check_equal(const HeightGrid& grid, const TerrainDomain& domain,
                        const SimplifyOptions& options = {}) {
  SimplifyReport planar, surface;
  const Tin plan = run(grid, domain, options, TerrainMetric::planar, planar);
  const Tin space = run(grid, domain, options, TerrainMetric::surface, surface);
  CHECK(are_equal(plan, space));
  CHECK(std::ranges::all_of(surface.surface.violations, [](const SphereViolation& v) {
    return v.kept_by == KeptBy::constraint;
  }));
  return plan.mesh.vertex_count() - planar.first_prefix;
}

HeightGrid level(std::uint32_t columns, std::uint32_t rows, double height = 0) {
  return grid_of(columns, rows, [&](double, double) { return height; });
}

}  // namespace

TEST_CASE("Surface metric: bounds are kept on hills, cliffs and spikes, in cells of any shape") {
  for (const double aspect : {1.0, 0.7, 1.3}) {
    for (HeightGrid grid :
         {hills(60, 45), steep_hills(60, 45), rough(40, 52, 7), wild(40, 30, 2)}) {
      grid.cell_height = aspect;
      for (const Effort effort : {Effort::fast, Effort::normal}) {
        const double bound = effort == Effort::fast ? 4 : 15;
        CAPTURE(aspect);
        CAPTURE(bound);
        SimplifyReport report;
        const Tin tin = run(grid, rectangle(grid), {.max_error = bound, .effort = effort},
                            TerrainMetric::surface, report);
        CHECK(report.goal_reached);
        CHECK(report.error.max <= bound * (1 + 1e-9));
        CHECK(measure_error(grid, tin).max == report.error.max);
        CHECK(report.error.lost == 0);
        check_surface(grid, tin, report);
        if (effort == Effort::fast) CHECK(report.surface.tame + report.surface.untame > 0);
      }
    }
  }
}

TEST_CASE("Surface metric: the error found is the error by brute force") {
  const HeightGrid grid = steep_hills(40, 30);
  SimplifyReport report;
  const Tin tin = run(grid, rectangle(grid), {.max_error = 3}, TerrainMetric::surface, report);
  CHECK(report.error.max == doctest::Approx(plain_error(grid, tin).max));
  CHECK(plain_error(grid, tin).lost == 0);
}

TEST_CASE("Surface metric: smallest angles in space are larger on average than by the plan") {
  for (const HeightGrid& grid : {steep_hills(80, 60), wild(40, 30, 3)}) {
    for (const Effort effort : {Effort::fast, Effort::normal}) {
      const SimplifyOptions options{.max_error = 2, .effort = effort};
      SimplifyReport planar, surface;
      run(grid, rectangle(grid), options, TerrainMetric::planar, planar);
      run(grid, rectangle(grid), options, TerrainMetric::surface, surface);
      CHECK(surface.surface.mean_min_angle_deg > planar.surface.mean_min_angle_deg + 2);
    }
  }
}

TEST_CASE("Surface metric: where cells are large the heights matter little") {
  HeightGrid grid = steep_hills(60, 45);
  grid.cell_width = grid.cell_height = 1000;
  SimplifyReport report;
  const Tin tin = run(grid, rectangle(grid), {.max_error = 2, .effort = Effort::fast},
                      TerrainMetric::surface, report);
  CHECK(report.surface.untame * 20 < report.surface.tame);
  CHECK(report.surface.min_angle_deg > 20);
  check_surface(grid, tin, report);
}

TEST_CASE("Level ground: equal bytes where lines meet at sharp angles, and blunt ones") {
  const HeightGrid grid = level(60, 40);
  TerrainDomain domain = rectangle(grid);
  add_chain(domain.pslg, {{5, 5}, {50, 9}, {7, 21}}, false);
  add_chain(domain.pslg, {{20.5, 30.25}, {41.25, 33.5}}, false);
  CHECK(check_equal(grid, domain) > 10);
  CHECK(check_equal(level(60, 40, 137.5), domain) > 10);
  HeightGrid tall = level(60, 40, -3);
  tall.cell_width = 30;
  tall.cell_height = 21;
  domain.pslg.points[2].y = domain.pslg.points[3].y = 39 * 0.7;
  domain.pslg.points[6].y = domain.pslg.points[7].y = domain.pslg.points[8].y = 20;
  CHECK(check_equal(tall, domain) > 10);
}

TEST_CASE("Level ground: equal bytes round holes without data") {
  HeightGrid grid = level(50, 40);
  for (std::uint32_t row = 12; row < 22; ++row) {
    for (std::uint32_t column = 20 + row % 3; column < 31; ++column) {
      grid.heights.set(grid.index(column, row), NAN);
    }
  }
  TerrainDomain domain;  // a stair as nodata outlines make it
  domain.pslg = polygon({0, 0, 49, 0, 49, 30, 47, 30, 47, 33, 44, 33, 44, 39, 2, 39, 2, 37, 0, 37});
  add_chain(domain.pslg, {{19, 17}, {20, 19}, {21, 17}, {31, 17}, {31, 28}, {20, 28}}, true);
  domain.pslg.holes.push_back({25, 22});
  CHECK(check_equal(grid, domain) > 5);
}

TEST_CASE("Level ground: equal bytes where angles are repaired, on random outlines with lines") {
  std::mt19937_64 random(21);
  std::size_t inserted = 0;
  for (int i = 0; i < 25; ++i) {
    CAPTURE(i);
    TerrainDomain domain;
    domain.pslg = random_star(random, i % 6);
    for (Point& p : domain.pslg.points) p = {30 + 29 * p.x, 30 + 29 * p.y};
    for (const double bound : {20.0, 30.0, 33.0}) {
      const Effort effort = i % 2 == 0 ? Effort::fast : Effort::normal;
      inserted += check_equal(level(60, 60), domain, {.effort = effort, .min_angle_deg = bound});
    }
  }
  CHECK(inserted > 500);
}

TEST_CASE("Level ground: equal bytes when the budget ends the repair") {
  const HeightGrid grid = level(200, 9);
  CHECK(check_equal(grid, rectangle(grid)) > 10);
  CHECK(check_equal(grid, rectangle(grid), {.max_vertices = 15}) > 0);
  CHECK(check_equal(grid, rectangle(grid), {.effort = Effort::best}) > 10);
}

TEST_CASE("Surface metric: the budget is kept, and said to be the reason") {
  const HeightGrid grid = steep_hills(40, 30);
  TerrainDomain fan = rectangle(grid);  // its edges are cut together
  fan.pslg.points.push_back({13.51, 8.91});
  for (const Point end : {Point{17.09, 15.3}, Point{17.8, 14.44}, Point{17.3, 19.26},
                          Point{12.03, 16.3}, Point{13.54, 13.39}}) {
    fan.pslg.points.push_back(end);
    const VertexId center(4U), last(fan.pslg.points.size() - 1);
    fan.pslg.segments.push_back({center, last, {}});
  }
  for (const TerrainDomain& domain : {rectangle(grid), fan}) {
    for (const auto& [effort, least] : {std::pair(Effort::fast, 91U), {Effort::normal, 124U}}) {
      for (std::size_t most = least; most < least + 6; ++most) {  // 97 and 130 were made
        CAPTURE(most);
        SimplifyReport report;
        const Tin tin =
            run(grid, domain, {.max_error = 0.2, .max_vertices = most, .effort = effort},
                TerrainMetric::surface, report);
        CHECK(tin.mesh.vertex_count() <= most);
        CHECK(tin.mesh.vertex_count() + 5 >= most);
        CHECK(!report.goal_reached);
        CHECK(std::ranges::all_of(report.unfinished, [](const Unfinished& u) {
          return is_forced_by_input(u.reason) || u.reason == Reason::budget;
        }));
        check_surface(grid, tin, report);
      }
    }
  }
}

TEST_CASE("Surface metric: a caller's stop ends it with a valid TIN") {
  const HeightGrid grid = steep_hills(120, 90);
  SimplifyOptions options{.max_error = 0.2};
  int calls = 0;
  options.progress = [&](std::size_t) { return ++calls < 2; };
  SimplifyReport report;
  const Tin tin = run(grid, rectangle(grid), options, TerrainMetric::surface, report);
  CHECK(calls == 2);
  CHECK(!report.goal_reached);
  check_surface(grid, tin, report);
}

TEST_CASE("Surface metric: levels are prefixes of one another, each within its bound") {
  const HeightGrid grid = steep_hills(70, 50);
  std::vector<Tin> tins;
  SimplifyOptions options{.max_error = 2};
  options.level_errors = {40, 10};
  options.on_level = [&](const Tin& tin, const TerrainLevel&) { tins.push_back(tin); };
  SimplifyReport report;
  tins.push_back(run(grid, rectangle(grid), options, TerrainMetric::surface, report));
  REQUIRE(tins.size() == 3);
  CHECK(report.levels[0].max_error <= 40);
  CHECK(report.levels[1].max_error <= 10);
  CHECK(report.levels[2].max_error <= 2);
  for (std::size_t level = 0; level + 1 < tins.size(); ++level) {
    const auto points = tins[level].mesh.points(), next = tins[level + 1].mesh.points();
    REQUIRE(points.size() < next.size());
    CHECK(std::equal(points.begin(), points.end(), next.begin()));
  }
  check_surface(grid, tins.back(), report);
}

TEST_CASE(
    "Surface metric: levels by counts, also where the coarse mesh is not complete at the first") {
  const HeightGrid grid = steep_hills(70, 50);
  TerrainDomain domain = rectangle(grid);
  add_chain(domain.pslg, {{5, 5}, {60, 9}, {7, 21}}, false);
  for (const Effort effort : {Effort::fast, Effort::normal}) {
    std::vector<Tin> tins;
    SimplifyOptions options{.max_vertices = 120, .effort = effort, .level_vertices = {12, 60}};
    options.on_level = [&](const Tin& tin, const TerrainLevel& level) {
      CHECK(measure_error(grid, tin).max == level.max_error);
      CHECK(validate(tin.mesh, {.delaunay = false}).summary() == "valid");
      tins.push_back(tin);
    };
    SimplifyReport report;
    tins.push_back(run(grid, domain, options, TerrainMetric::surface, report));
    REQUIRE(tins.size() == 3);
    for (std::size_t level = 0; level + 1 < tins.size(); ++level) {
      const auto points = tins[level].mesh.points(), next = tins[level + 1].mesh.points();
      REQUIRE(points.size() < next.size());
      CHECK(std::equal(points.begin(), points.end(), next.begin()));
    }
    check_surface(grid, tins.back(), report);
  }
}

TEST_CASE("Surface metric: a bound of 0 ends, and so does one without angles") {
  const HeightGrid grid = wild(17, 14, 1);
  SimplifyReport report;
  const Tin tin = run(grid, rectangle(grid), {}, TerrainMetric::surface, report);
  CHECK(report.error.max < 1e-9);
  check_surface(grid, tin, report);
  const Tin any = run(grid, rectangle(grid), {.max_error = 3, .min_angle_deg = 0},
                      TerrainMetric::surface, report);
  CHECK(report.goal_reached);
  check_surface(grid, any, report, 0);
}

TEST_CASE("Surface metric: lines stay, hard ones with their heights, and borders that are kept") {
  const HeightGrid grid = steep_hills(40, 30);
  TerrainDomain domain = rectangle(grid);
  domain.kept_border.assign(4, true);
  add_chain(domain.pslg, {{5.5, 6.25}, {33.25, 21.5}}, false);
  domain.fixed_heights.assign(6, std::numeric_limits<double>::quiet_NaN());
  domain.fixed_heights[4] = 10;
  domain.fixed_heights[5] = 20;
  domain.hard_segments = {false, false, false, false, true};
  domain.kept_border.resize(6, false);
  SimplifyReport report;
  const Tin tin = run(grid, domain, {.max_error = 2}, TerrainMetric::surface, report);
  std::size_t on_line = 0, on_border = 0;
  for (std::size_t i = 0; i < tin.mesh.vertex_count(); ++i) {
    const Point p = tin.mesh.point(VertexId(i)), a{5.5, 6.25}, d{27.75, 15.25};
    on_border += p.x == 0 || p.y == 0 || p.x == 39 || p.y == 29 ? 1 : 0;
    const double along = dot(p - a, d) / dot(d, d);
    if (std::abs(cross(p - a, d)) > 1e-9 || along < 0 || along > 1) continue;
    ++on_line;
    CHECK(tin.heights[i] == doctest::Approx(10 + 10 * along));
  }
  CHECK(on_border == 4);
  CHECK(on_line >= 2);
  CHECK(validate(tin.mesh, {.delaunay = false}).summary() == "valid");
}

TEST_CASE("Surface metric: the same bytes on every run") {
  const HeightGrid grid = wild(50, 40, 6);
  SimplifyReport report;
  const auto once = [&] {
    return run(grid, rectangle(grid), {.max_error = 6}, TerrainMetric::surface, report);
  };
  CHECK(are_equal(once(), once()));
}

TEST_CASE("Surface metric: greedy insertion does not know it") {
  const HeightGrid grid = hills(10, 10);
  SimplifyReport report;
  CHECK_THROWS_AS(
      run(grid, rectangle(grid), {.by = SimplifyBy::greedy}, TerrainMetric::surface, report),
      InputError);
}
