#include <doctest/doctest.h>

#include <limits>

#include "lepp/terrain/fit_heights.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "terrain/hills.hpp"
#include "terrain/plain_error.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

struct Made {
  TerrainDomain domain;
  Tin tin;
};

Made made(const HeightGrid& grid, double max_error, SimplifyBy by,
          const DomainOptions& lines = {}) {
  Made made;
  made.domain = terrain_domain(grid, lines);
  SimplifyOptions options;
  options.max_error = max_error;
  options.by = by;
  SimplifyReport report;
  made.tin = simplify(grid, made.domain, options, report);
  REQUIRE(report.goal_reached);
  return made;
}

// The sum of squares over samples, each counted once.
double squares(const HeightGrid& grid, const Tin& tin) {
  return plain_error(grid, tin).sum_of_squares;
}

}  // namespace

TEST_CASE("fit_heights: keeps the bound and lowers the root mean square, places stay") {
  for (const SimplifyBy by : {SimplifyBy::lepp, SimplifyBy::greedy}) {
    for (const HeightGrid& grid : {hills(40, 31), rough(37, 40, 5)}) {
      const double max_error = 8;
      Made made = ::made(grid, max_error, by);
      const Tin before = made.tin;
      fit_heights(grid, made.tin, {max_error});
      CHECK(std::ranges::equal(made.tin.mesh.points(), before.mesh.points()));
      const PlainError found = plain_error(grid, made.tin);
      CHECK(found.max <= max_error * (1 + 1e-12));
      CHECK(found.sum_of_squares < 0.85 * squares(grid, before));
    }
  }
}

TEST_CASE("fit_heights: far from 0 as near to it") {
  HeightGrid grid = rough(37, 40, 5), high = grid;
  for (std::size_t i = 0; i < grid.size(); ++i) high.heights.set(i, 1e9 + 1e-3 * grid.heights[i]);
  Made near = ::made(grid, 8, SimplifyBy::greedy), far{near.domain, near.tin};
  for (double& height : far.tin.heights) height = 1e9 + 1e-3 * height;
  fit_heights(grid, near.tin, {8});
  fit_heights(high, far.tin, {8e-3});
  for (std::size_t i = 0; i < near.tin.heights.size(); ++i) {
    CHECK(far.tin.heights[i] - 1e9 == doctest::Approx(1e-3 * near.tin.heights[i]).epsilon(1e-3));
  }
}

TEST_CASE("fit_heights: without a bound the heights are those of least squares") {
  const HeightGrid grid = rough(23, 26, 9);
  Made made = ::made(grid, 20, SimplifyBy::lepp);
  FitOptions options;
  options.max_error = 1e6;
  options.max_sweeps = 200;
  fit_heights(grid, made.tin, options);
  const double least = squares(grid, made.tin);
  for (double& height : made.tin.heights) {  // any change makes it worse
    const double kept = height;
    for (const double step : {-0.5, 0.5}) {
      height = kept + step;
      CHECK(squares(grid, made.tin) > least);
    }
    height = kept;
  }
}

TEST_CASE("fit_heights: a TIN that is beyond the bound gets no worse") {
  const HeightGrid grid = rough(30, 30, 2);
  Made made = ::made(grid, 10, SimplifyBy::greedy);
  const double before = plain_error(grid, made.tin).max;
  fit_heights(grid, made.tin, {before / 4});
  CHECK(plain_error(grid, made.tin).max <= before * (1 + 1e-12));
}

TEST_CASE("fit_heights: hard lines and borders of tiles keep their heights; nodata has no say") {
  HeightGrid grid = rough(41, 33, 4);
  for (std::uint32_t row = 10; row < 15; ++row) {
    for (std::uint32_t column = 20; column < 27; ++column) {
      grid.heights.set(grid.index(column, row), std::numeric_limits<double>::quiet_NaN());
    }
  }
  Breakline line{{{3, -5}, {15, -28}}, {20, 60}, "line"};
  Made made = ::made(grid, 200, SimplifyBy::lepp, {{}, {line}});
  made.domain.kept_border.assign(made.domain.pslg.points.size(), true);
  const std::vector<bool> fixed = fixed_vertices(grid, made.domain, made.tin);
  const Tin before = made.tin;
  FitOptions options;
  options.max_error = 200;
  options.is_fixed = fixed;
  fit_heights(grid, made.tin, options);
  std::size_t on_line = 0, moved = 0;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    const Point p = before.mesh.point(VertexId(i));
    const bool on_border = p.x == 0 || p.y == 0 || p.x == 40 || p.y == 32;
    if (on_border) CHECK(fixed[i]);
    on_line += fixed[i] && !on_border ? 1 : 0;
    if (fixed[i]) CHECK(made.tin.heights[i] == before.heights[i]);
    else moved += made.tin.heights[i] != before.heights[i] ? 1 : 0;
  }
  CHECK(on_line >= 2);
  CHECK(moved > 0);
}

TEST_CASE("fit_heights: stops when asked to, within the bound") {
  const HeightGrid grid = hills(30, 30);
  Made made = ::made(grid, 5, SimplifyBy::lepp);
  FitOptions options;
  options.max_error = 5;
  options.go_on = [] { return false; };
  CHECK(fit_heights(grid, made.tin, options) == 1);
  CHECK(plain_error(grid, made.tin).max <= 5 * (1 + 1e-12));
}

TEST_CASE("fit_heights: no vertex goes farther than samples may be off, however little it weighs") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    HeightGrid grid = grid_of(2 + random.below(6), 2 + random.below(6),
                              [&](double, double) { return std::round(random.real(-30, 30)); });
    for (std::size_t i = 1; i < grid.size(); ++i) {
      if (random.one_in(4)) grid.heights.set(i, std::numeric_limits<double>::quiet_NaN());
    }
    grid.cell_height = 1.0 / 3;
    grid.step_y = -grid.cell_height;
    const double max_error = random.one_in(2) ? 8 : 1;
    Made made = ::made(grid, max_error, SimplifyBy::lepp);
    const Tin before = made.tin;
    fit_heights(grid, made.tin, {max_error});
    for (std::size_t i = 0; i < before.heights.size(); ++i) {
      CHECK(std::abs(made.tin.heights[i] - before.heights[i]) <= max_error * (1 + 1e-12));
    }
    const TerrainError was = measure_error(grid, before), is = measure_error(grid, made.tin);
    CHECK(is.max <= std::max(max_error, was.max));
    CHECK(is.rms <= was.rms + 1e-12);
  }
}

// The one sample that the vertex at (1.5, 1.5) has a say in is next to two others: its error,
// divided by the weight of the first, would take that out of sight.
TEST_CASE("fit_heights: a vertex that no sample is near keeps its height") {
  HeightGrid grid = grid_of(4, 4, [](double, double) { return 0; });
  raise(grid, 2, grid.row_of_line(2), 8);
  Pslg pslg = polygon({0, 0, 3, 0, 3, 3, 0, 3});
  for (const Point p : {Point{2.0001, 2}, Point{2, 2.0001}, Point{1.5, 1.5}, Point{1.2, 1.2},
                        Point{1.8, 1.2}, Point{1.2, 1.8}}) {
    pslg.points.push_back(p);
  }
  Tin tin{constrained_delaunay(pslg).mesh, {}};
  for (const Point p : tin.mesh.points()) tin.heights.push_back(p.x == 1.5 ? 1 : 0);
  FitOptions options;
  options.max_error = 1e9;
  for (const double height : tin.heights) options.is_fixed.push_back(height == 0);
  fit_heights(grid, tin, options);
  CHECK(std::ranges::count(tin.heights, 1.0) == 1);
}
