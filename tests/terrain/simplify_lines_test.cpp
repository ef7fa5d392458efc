#include <doctest/doctest.h>

#include <cmath>

#include "lepp/terrain/simplify.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/random.hpp"
#include "terrain/hills.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

// Hills with a round gap, and lines that may cross each other, the gap and the rim at any angle.
struct Site {
  HeightGrid grid;
  DomainOptions lines;
};

Site random_site(Random& random) {
  Site site;
  const std::uint32_t columns = 8 + random.below(40), rows = 8 + random.below(40);
  site.grid = random.one_in(2) ? hills(columns, rows) : rough(columns, rows, random.next());
  site.grid.cell_height = random.one_in(2) ? 1 : random.real(0.5, 2);
  const double x = random.real(0, columns), y = random.real(0, rows), radius = random.real(0, 6);
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      if (std::hypot(column - x, row - y) > radius) continue;
      site.grid.heights.set(site.grid.index(column, row), NAN);
    }
  }
  for (std::uint32_t i = random.below(4); i-- > 0;) {
    Breakline line;
    for (std::uint32_t k = 2 + random.below(3); k-- > 0;) {
      line.points.push_back({random.real(0, columns - 1), -random.real(0, rows - 1)});
    }
    site.lines.breaklines.push_back(line);
  }
  return site;
}

}  // namespace

TEST_CASE("simplify with gaps and lines: bounds hold, and small angles are the input's") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const Site site = random_site(random);
    SimplifyOptions options;
    options.max_error = random.real(1, 20);
    options.min_angle_deg = random.one_in(2) ? 30 : 20.7;
    options.by = random.one_in(4) ? SimplifyBy::greedy : SimplifyBy::lepp;
    SimplifyReport report;
    const Tin tin = simplify(site.grid, terrain_domain(site.grid, site.lines), options, report);
    MeshClaims claims;
    if (options.by == SimplifyBy::lepp) {
      claims.min_angle_deg = options.min_angle_deg;
      claims.unfinished = report.unfinished;
    }
    CHECK(validate(tin.mesh, claims).summary() == "valid");
    CHECK(report.goal_reached);
    CHECK(report.error.max <= options.max_error * (1 + 1e-9) + 1e-9);
    CHECK(report.error.lost == 0);
    CHECK(report.error.covered == 0);
  }
}

// The line runs along the outline of the gap, 0.14 cells beside it: a sample near a line, but
// beyond its end, was taken for one on it.
TEST_CASE("simplify: a line close to the outline and nearly parallel to it") {
  HeightGrid grid = hills(60, 19);
  for (const std::uint32_t row : {7U, 8U}) {
    for (std::uint32_t column = 25; column <= 30; ++column) {
      if (row == 7 || column < 30) {
        grid.heights.set(grid.index(column, row - 1), NAN);
      }
    }
  }
  for (const double beside : {0.02, 0.06, 0.14, 0.3}) {
    CAPTURE(beside);
    DomainOptions lines;
    lines.breaklines.push_back({{{23.5, -(8 + beside)}, {32.9, -(7.9 + beside)}}, {}, "stream"});
    lines.breaklines.push_back({{{20.1, -3.2}, {41.7, -12.6}}, {}, "path"});
    for (const TerrainMetric metric : {TerrainMetric::planar, TerrainMetric::surface}) {
      for (const double bound : {0.5, 5.0}) {
        SimplifyReport report;
        SimplifyOptions options{.max_error = bound, .metric = metric, .min_angle_deg = 20.7};
        const Tin tin = simplify(grid, terrain_domain(grid, lines), options, report);
        CHECK(report.goal_reached);
        CHECK(report.error.max <= bound * (1 + 1e-9));
        CHECK(validate(tin.mesh, {.delaunay = metric == TerrainMetric::planar}).summary() ==
              "valid");
      }
    }
  }
}
