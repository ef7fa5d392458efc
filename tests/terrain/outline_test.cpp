#include "lepp/terrain/outline.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "support/random.hpp"
#include "terrain/grids.hpp"

using namespace lepp;
using test::grid_of;

namespace {

double twice_area(const Outline& outline) {
  double area = 0;
  for (const auto& [i, j] : outline.edges) {
    const LatticePoint a = outline.corners[i], b = outline.corners[j];
    area += double(a.column) * b.line - double(b.column) * a.line;
  }
  return area;
}

bool has_corner(const Outline& outline, LatticePoint p) {
  return std::ranges::find(outline.corners, p) != outline.corners.end();
}

/// Data below a line of this slope, on a grid of n x n.
HeightGrid half_plane(std::uint32_t n, double slope) {
  std::vector<std::string> rows(n, std::string(n, '.'));
  for (std::uint32_t line = 0; line < n; ++line) {
    for (std::uint32_t column = 0; column < n; ++column) {
      if (line < 1.5 + slope * column) rows[n - 1 - line][column] = '1';
    }
  }
  return grid_of(rows);
}

}  // namespace

TEST_CASE("a cell of three samples is a triangle") {
  const Outline outline = outline_of(grid_of({"1.", "11"}));
  CHECK(outline.corners.size() == 3);
  CHECK(twice_area(outline) == 1);
  CHECK(outline.islands.empty());
}

TEST_CASE("holes that touch at a sample share the corner, each ring keeps its side") {
  const HeightGrid grid = grid_of({"1111111", "1.1.111", "1111111", "11.1.11", "1111111"});
  const Outline outline = outline_of(grid);
  std::map<std::uint32_t, int> leaving;
  for (const auto& [a, b] : outline.edges) ++leaving[a];
  std::size_t shared = 0;
  for (const auto& [corner, count] : leaving) shared += count == 2;
  CHECK(shared == 7);  // two between holes, five on the rim
  CHECK(has_corner(outline, {3, 1}));
  CHECK(has_corner(outline, {2, 3}));
  CHECK(twice_area(outline) == 2 * (6 * 4) - 4 * 4);  // each hole is a diamond of area 2
}

TEST_CASE("a sample without a full cell is an island; neighbours in a chain are one each") {
  const Outline outline = outline_of(grid_of({"11...", "11.2.", ".....", "..345"}));
  REQUIRE(outline.islands.size() == 4);
  CHECK(outline.islands[0] == LatticePoint{2, 0});
  CHECK(outline.islands[3] == LatticePoint{3, 2});
  CHECK(outline.corners.size() == 4);
}

TEST_CASE("notches without a sample are filled: a straight coast takes few corners") {
  for (const double slope : {0.0, 0.2, 0.377, 0.61803, 0.95}) {
    CAPTURE(slope);
    CHECK(outline_of(half_plane(100, slope)).corners.size() <= 10);
  }
}

TEST_CASE("no corner of the covered area is sharper than 45 degrees") {
  constexpr std::uint64_t seed = 5;
  CAPTURE(seed);
  test::Random random(seed);
  for (int i = 0; i < 300; ++i) {
    CAPTURE(i);
    std::vector<std::string> rows(20, std::string(20, '.'));
    const double share = random.real(0.3, 0.95);
    for (std::string& row : rows) {
      for (char& c : row) {
        if (random.real() < share) c = '1';
      }
    }
    const Outline outline = outline_of(grid_of(rows));
    // Edges come ring by ring: each begins where the one before it ends, or a ring begins.
    double least = 360;
    std::size_t first = 0;
    for (std::size_t e = 0; e < outline.edges.size(); ++e) {
      const bool last = e + 1 == outline.edges.size() ||
                        outline.edges[e + 1][0] != outline.edges[e][1] ||
                        outline.edges[e][1] == outline.edges[first][0];
      const auto& next = outline.edges[last ? first : e + 1];
      if (last) first = e + 1;
      const LatticePoint a = outline.corners[outline.edges[e][0]];
      const LatticePoint b = outline.corners[next[0]], c = outline.corners[next[1]];
      const double back = std::atan2(double(a.line) - b.line, double(a.column) - b.column);
      const double on = std::atan2(double(c.line) - b.line, double(c.column) - b.column);
      double angle = (back - on) * 180 / std::numbers::pi;
      if (angle <= 1e-9) angle += 360;
      least = std::min(least, angle);
    }
    CHECK(least >= 45 - 1e-9);
  }
}
