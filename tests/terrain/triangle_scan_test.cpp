#include "lepp/terrain/triangle_scan.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "lepp/geometry/predicates.hpp"
#include "terrain/hills.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

Point place(const TerrainCorner& c) { return {c.column, c.line}; }

bool contains(const std::array<TerrainCorner, 3>& t, Point p) {
  const int turn = orient2d(place(t[0]), place(t[1]), place(t[2]));
  for (std::size_t i = 0; i < 3; ++i) {
    if (orient2d(place(t[i]), place(t[(i + 1) % 3]), p) * turn < 0) return false;
  }
  return true;
}

std::set<std::pair<std::uint32_t, std::uint32_t>> samples(const HeightGrid& grid,
                                                          const std::array<TerrainCorner, 3>& t) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> found;
  TriangleSpans spans(grid);
  spans(t, [&](const ScanSpan& s) {
    for (std::uint32_t c = s.first; c <= s.last; ++c) CHECK(found.insert({c, s.line}).second);
    return true;
  });
  return found;
}

}  // namespace

TEST_CASE("TriangleSpans: exactly the samples of the closed triangle, for corners on samples") {
  const HeightGrid grid = hills(23, 19);
  constexpr std::uint64_t seed = 11;
  CAPTURE(seed);
  Random random(seed);
  for (int i = 0; i < 300; ++i) {
    std::array<TerrainCorner, 3> t;
    for (auto& c : t) c = {double(random.below(23)), double(random.below(19)), 0};
    if (orient2d(place(t[0]), place(t[1]), place(t[2])) == 0) continue;
    const auto found = samples(grid, t);
    for (std::uint32_t c = 0; c < grid.columns; ++c) {
      for (std::uint32_t l = 0; l < grid.rows; ++l) {
        REQUIRE((found.count({c, l}) == 1) == contains(t, {double(c), double(l)}));
      }
    }
  }
}

TEST_CASE("TriangleSpans: no sample between two triangles is lost, whatever their corners") {
  const HeightGrid grid = hills(23, 19);
  constexpr std::uint64_t seed = 12;
  CAPTURE(seed);
  Random random(seed);
  for (int i = 0; i < 100; ++i) {
    // Four triangles around a point fill the grid.
    const std::array<TerrainCorner, 4> rim{{{0, 0, 0}, {22, 0, 0}, {22, 18, 0}, {0, 18, 0}}};
    const TerrainCorner p{random.real(0.01, 21.99), random.real(0.01, 17.99), 0};
    std::set<std::pair<std::uint32_t, std::uint32_t>> all;
    for (std::size_t k = 0; k < 4; ++k) all.merge(samples(grid, {rim[k], rim[(k + 1) % 4], p}));
    REQUIRE(all.size() == grid.size());
  }
}

TEST_CASE("TriangleScan: the worst sample, and where") {
  HeightGrid grid = grid_of(9, 7, [](double x, double y) { return 3 * x - 2 * (6 - y) + 10; });
  const auto corner = [](double c, double l) { return TerrainCorner{c, l, 3 * c - 2 * l + 10}; };
  const std::array<TerrainCorner, 3> t{corner(0, 0), corner(8, 0), corner(0, 6)};
  CHECK(TriangleScan(grid).worst(t).error < 1e-12);
  raise(grid, 2, grid.row_of_line(3), 5);    // inside
  raise(grid, 4, grid.row_of_line(3), -7);   // on the long side
  raise(grid, 7, grid.row_of_line(5), 100);  // outside
  raise(grid, 8, grid.row_of_line(0), 50);   // a corner
  grid.heights.set(grid.index(1, grid.row_of_line(1)), NAN);
  const WorstSample worst = TriangleScan(grid).worst(t);
  CHECK(worst.error == doctest::Approx(7));
  CHECK(worst.at == Sample{4, 3});
  CHECK(TriangleScan(grid).is_within(t, 7.001));
  CHECK(!TriangleScan(grid).is_within(t, 6.999));
  const WorstSample beside =
      TriangleScan(grid).worst(t, 1);  // the long side lies opposite corner 0
  CHECK(beside.error == doctest::Approx(5));
  CHECK(beside.at == Sample{2, 3});
  CHECK(TriangleScan(grid).is_within(t, 5.001, 1));
  CHECK(!TriangleScan(grid).is_within(t, 6.999, 6));
}
