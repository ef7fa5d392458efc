#include "lepp/terrain/tile_border.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "terrain/hills.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

const double no_data = std::numeric_limits<double>::quiet_NaN();

std::vector<double> line_of(std::size_t n, auto height) {
  std::vector<double> heights;
  for (std::size_t i = 0; i < n; ++i) heights.push_back(height(double(i)));
  return heights;
}

double largest_error(const std::vector<double>& heights, const std::vector<std::uint32_t>& at) {
  double largest = 0;
  for (std::size_t k = 0; k + 1 < at.size(); ++k) {
    for (std::uint32_t i = at[k]; i <= at[k + 1]; ++i) {
      const double t = double(i - at[k]) / double(at[k + 1] - at[k]);
      largest = std::max(largest,
                         std::abs((1 - t) * heights[at[k]] + t * heights[at[k + 1]] - heights[i]));
    }
  }
  return largest;
}

// The vertices of a tin's domain on a vertical line of samples: (line, height) by line.
std::set<Point> border_points(const TerrainDomain& domain, double x) {
  std::set<Point> points;
  for (const Segment& s : domain.pslg.segments) {
    for (const VertexId v : {s.a, s.b}) {
      const Point p = domain.pslg.points[v.index()];
      if (p.x == x) points.insert({0, p.y});
    }
  }
  return points;
}

HeightGrid part_of(const HeightGrid& grid, std::uint32_t first, std::uint32_t columns) {
  return grid_of(columns, grid.rows, [&](double column, double row) {
    return grid.height(first + static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
  });
}

}  // namespace

TEST_CASE("the samples of a border keep the error, and pieces side by side differ by a factor 2") {
  Random random(7);
  const auto heights = line_of(501, [&](double x) {
    return 40 * std::sin(x / 30) + (x > 320 ? 60 : 0) + double(random.below(3));
  });
  for (const double error : {0.0, 0.5, 3.0, 10.0, 1000.0}) {
    CAPTURE(error);
    const auto at = border_samples(heights, error);
    CHECK(at.front() == 0);
    CHECK(at.back() == 500);
    CHECK(largest_error(heights, at) <= error + 1e-9);
    CHECK(at[1] == 1);  // corners of tiles match
    CHECK(at[at.size() - 2] == 499);
    for (std::size_t k = 2; k < at.size(); ++k) {
      const std::uint32_t before = at[k - 1] - at[k - 2], after = at[k] - at[k - 1];
      CHECK(std::max(before, after) <= 2 * std::min(before, after));
    }
  }
  CHECK(border_samples(heights, 1000).size() < 25);
  CHECK(border_samples(heights, 0).size() > 400);
}

TEST_CASE("runs of a border without data between them stand alone") {
  std::vector<double> heights(20, 1.0);
  heights[5] = heights[7] = heights[8] = no_data;
  const auto at = border_samples(heights, 0.1);
  CHECK(std::ranges::find(at, 4U) != at.end());
  CHECK(std::ranges::find(at, 6U) != at.end());  // a sample alone
  CHECK(std::ranges::find(at, 9U) != at.end());
  CHECK(std::ranges::is_sorted(at));
  for (const std::uint32_t i : at) CHECK(!std::isnan(heights[i]));
  CHECK(border_samples(std::vector<double>(4, no_data), 1).empty());
  CHECK(border_samples(std::vector<double>{2.0}, 1) == std::vector<std::uint32_t>{0});
}

TEST_CASE("two grids that share a line get the same vertices on it") {
  const HeightGrid whole = rough(61, 47, 3);
  const HeightGrid west = part_of(whole, 0, 31), east = part_of(whole, 30, 31);
  for (const double error : {2.0, 15.0}) {
    CAPTURE(error);
    TerrainDomain left = rectangle(west), right = rectangle(east);
    fix_borders(west, error, left);
    fix_borders(east, error, right);
    const auto shared = border_points(left, 30);
    CHECK(shared.size() > 10);
    CHECK(shared == border_points(right, 0));
  }
}

TEST_CASE("sides that are borders are not cut, in either way of simplifying") {
  const HeightGrid grid = rough(40, 30, 5);
  for (const SimplifyBy by : {SimplifyBy::lepp, SimplifyBy::greedy}) {
    TerrainDomain domain = rectangle(grid);
    fix_borders(grid, 10, domain);
    SimplifyReport report;
    SimplifyOptions options;
    options.max_error = 10;
    options.by = by;
    const Tin tin = simplify(grid, domain, options, report);
    std::set<Point> wanted, found;
    const Point corner = grid.sample(grid.columns - 1, grid.rows - 1);
    const auto is_on_side = [&](Point p) {
      return p.x == 0 || p.y == 0 || p.x == corner.x || p.y == corner.y;
    };
    for (const Point p : domain.pslg.points) wanted.insert(p);
    for (const Point p : tin.mesh.points()) {
      if (is_on_side(p)) found.insert(p);
    }
    CHECK(found == wanted);
    CHECK(report.error.max <= 10 + 1e-9);
  }
}

TEST_CASE("pieces of a border keep the curve of their side") {
  const HeightGrid grid = hills(20, 12);
  TerrainDomain domain = terrain_domain(grid);
  const auto curve = domain.pslg.segments[0].curve;
  fix_borders(grid, 5, domain);
  CHECK(domain.kept_border.size() == domain.pslg.points.size());
  CHECK(domain.fixed_heights.size() == domain.pslg.points.size());
  CHECK(validate(domain.pslg).empty());
  for (const Segment& s : domain.pslg.segments) CHECK(s.curve == curve);
}

TEST_CASE("a corner of the outline beside a border ends a run of it") {
  const std::vector<double> flat(41, 5.0f);
  const std::vector<std::uint32_t> corners = {0, 17, 40};
  const auto at = border_samples(flat, 1, corners);
  for (const std::uint32_t i : {0U, 1U, 16U, 17U, 18U, 39U, 40U}) {
    CHECK(std::ranges::find(at, i) != at.end());
  }
  CHECK(std::ranges::adjacent_find(at) == at.end());
}

TEST_CASE("near a border is nearer than twice its pieces there") {
  const HeightGrid grid = hills(65, 65);
  TerrainDomain domain = rectangle(grid);
  fix_borders(grid, 1e9, domain);  // pieces of 1, 2, 4, 8, 16 samples from each corner
  const NearBorder is_near(grid, domain);
  CHECK(is_near({0, 30}));
  CHECK(is_near({20, 32}));
  CHECK(is_near({64 - 20, 32}));
  CHECK(is_near({1, 1}));
  TerrainDomain fine = rectangle(grid);
  fix_borders(grid, 0, fine);  // pieces of one sample on hills
  CHECK_FALSE(NearBorder(grid, fine)({20, 32}));
}

TEST_CASE("an outline from one fixed side to another is cut where the error asks for it") {
  const HeightGrid grid = grid_of(
      3, 3, [](double x, double y) { return x == 2 ? double(no_data) : x * (y == 1 ? 9 : 5); });
  TerrainDomain domain = terrain_domain(grid);
  fix_borders(grid, 1, domain);
  SimplifyOptions options;
  options.max_error = 1;
  for (const SimplifyBy by : {SimplifyBy::lepp, SimplifyBy::greedy}) {
    options.by = by;
    SimplifyReport report;
    const Tin tin = simplify(grid, domain, options, report);
    CHECK(measure_error(grid, tin).max <= 1);
    CHECK(report.goal_reached);
  }
}

TEST_CASE("fixed sides get no vertex, also where the outline meets them at a sharp angle") {
  Random random(20261126);
  std::size_t sharp = 0;
  for (int trial = 0; trial < 60; ++trial) {
    CAPTURE(trial);
    const HeightGrid grid = grid_of(9, 8, [&](double, double) {
      return random.below(4) == 0 ? double(no_data) : static_cast<double>(random.below(50));
    });
    TerrainDomain domain = terrain_domain(grid);
    fix_borders(grid, 0, domain);
    const double right = grid.columns - 1, top = grid.rows - 1;
    const auto on_side = [&](Point p) {
      return p.x == 0 || p.x == right || p.y == 0 || p.y == top;
    };
    SimplifyOptions options;
    options.max_error = 5;
    SimplifyReport report;
    const Tin tin = simplify(grid, domain, options, report);
    for (const Point p : tin.mesh.points()) {
      if (on_side(p)) CHECK(std::ranges::find(domain.pslg.points, p) != domain.pslg.points.end());
    }
    for (const auto& u : report.unfinished) sharp += u.reason == Reason::kept_border ? 1 : 0;
  }
  CHECK(sharp > 0);  // some triangles do suffer, and say so
}

TEST_CASE(
    "grids cut apart elsewhere have the same vertices along what both outlines follow, but where "
    "one of them turns") {
  constexpr std::uint64_t seed = 3;
  CAPTURE(seed);
  Random random(seed);
  constexpr std::uint32_t columns = 11, rows = 40, middle = 5;
  std::size_t compared = 0;
  for (int i = 0; i < 100; ++i) {
    CAPTURE(i);
    const double share = random.real(0.02, 0.3);
    const HeightGrid whole = grid_of(columns, rows, [&](double x, double y) {
      return random.real() < share ? double(no_data) : hill(x, 3 * y);
    });
    const HeightGrid west = part_of(whole, 0, middle + 1);
    const HeightGrid east = part_of(whole, middle, columns - middle);
    std::array<std::vector<bool>, 2> vertex, covered;
    std::vector<bool> turns(rows);
    for (const std::size_t k : {0, 1}) {
      const HeightGrid& grid = k == 0 ? west : east;
      TerrainDomain domain = terrain_domain(grid, {.islands_stay_inside = true});
      const double line = k == 0 ? middle : 0;
      for (const Point p : domain.pslg.points) {
        if (p.x == line) turns[std::size_t(p.y)] = true;
      }
      fix_borders(grid, 10, domain);
      vertex[k].resize(rows);
      covered[k].resize(rows);
      for (const Segment& s : domain.pslg.segments) {
        const Point a = domain.pslg.points[s.a.index()], b = domain.pslg.points[s.b.index()];
        if (a.x != line || b.x != line) continue;
        const auto [low, high] = std::minmax(a.y, b.y);
        vertex[k][std::size_t(low)] = vertex[k][std::size_t(high)] = true;
        for (auto y = std::size_t(low); y < std::size_t(high); ++y) covered[k][y] = true;
      }
    }
    for (std::size_t y = 1; y + 1 < rows; ++y) {
      if (!(covered[0][y - 1] && covered[0][y] && covered[1][y - 1] && covered[1][y])) continue;
      if (turns[y]) continue;
      REQUIRE(vertex[0][y] == vertex[1][y]);
      ++compared;
    }
  }
  CHECK(compared > 200);
}
