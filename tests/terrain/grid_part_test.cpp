#include "lepp/terrain/grid_part.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "lepp/terrain/terrain_domain.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/random.hpp"
#include "terrain/grids.hpp"

using namespace lepp;

namespace {

constexpr std::uint32_t columns = 13, rows = 9, middle = 6;

HeightGrid random_grid(test::Random& random, bool south_up) {
  const double share = random.real(0.3, 0.95);
  std::vector<std::string> picture(rows, std::string(columns, '.'));
  for (std::string& row : picture) {
    for (char& c : row) {
      if (random.real() < share) c = '1';
    }
  }
  HeightGrid grid = test::grid_of(picture);
  if (south_up) grid.step_y = -grid.step_y;
  return grid;
}

/// What the domain of a part covers, samples by their place in the whole.
struct Cover {
  std::map<Point, int> samples;
  Pslg pslg;
};

Cover cover_of(const HeightGrid& grid, double west) {
  Cover cover;
  if (!grid.has_any_data()) return cover;
  cover.pslg = terrain_domain(grid).pslg;
  const Mesh mesh = constrained_delaunay(cover.pslg).mesh;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    for (double x = 0; x < grid.columns; ++x) {
      for (double y = 0; y < grid.rows; ++y) {
        const Point p{x, y};
        const bool in =
            cross(b - a, p - a) >= 0 && cross(c - b, p - b) >= 0 && cross(a - c, p - c) >= 0;
        if (in) cover.samples[{x + west, y}] = 1;
      }
    }
  }
  return cover;
}

}  // namespace

TEST_CASE("a part knows what lies around it, whichever row is the first") {
  for (const bool south_up : {false, true}) {
    CAPTURE(south_up);
    HeightGrid grid = test::grid_of({"1.1.", ".11.", "1.11", "111."});
    if (south_up) grid.step_y = 1;
    const GridPart part = part_of(grid, {1, 1, 2, 2});
    CHECK(part.grid.heights.size() == 4);
    for (std::int64_t line = -1; line <= 2; ++line) {
      for (std::int64_t column = -1; column <= 2; ++column) {
        const auto whole_line = static_cast<std::uint32_t>(line + 1);
        CHECK(part.has_data(column, line) ==
              grid.has_data(static_cast<std::uint32_t>(column + 1), grid.row_of_line(whole_line)));
      }
    }
    const GridPart all = part_of(grid, {0, 0, 4, 4});
    CHECK(all.north.empty());
    CHECK(!all.has_data(-1, -1));
    CHECK(part.grid.to_world({0, 0}) == grid.to_world({1, 1}));
  }
}

TEST_CASE(
    "a part of a grid has its very heights, and keeps them as floats where all of its own are") {
  HeightGrid grid = test::grid_of({"12345", "67890", "12345"});
  grid.heights.set(grid.index(4, 1), 1e6 + 1e-6);
  const GridPart west = part_of(grid, {0, 0, 4, 3}), east = part_of(grid, {2, 0, 3, 3});
  CHECK(west.grid.heights.are_floats());
  CHECK(west.grid.height(3, 1) == 9);
  CHECK(!east.grid.heights.are_floats());
  CHECK(east.grid.height(2, 1) == 1e6 + 1e-6);
}

TEST_CASE(
    "parts side by side: every sample is in one, nothing overlaps, corners on the border agree") {
  constexpr std::uint64_t seed = 11;
  CAPTURE(seed);
  test::Random random(seed);
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    const HeightGrid whole = random_grid(random, i % 2 == 1);
    GridPart west = part_of(whole, {0, 0, middle + 1, rows});
    GridPart east = part_of(whole, {middle, 0, columns - middle, rows});
    const auto corners = border_corners(west, GridSide::east);
    REQUIRE(corners == border_corners(east, GridSide::west));
    leave_to_neighbours(west);
    leave_to_neighbours(east);
    const Cover a = cover_of(west.grid, 0), b = cover_of(east.grid, middle);

    for (std::uint32_t line = 0; line < rows; ++line) {
      for (std::uint32_t column = 0; column < columns; ++column) {
        const Point p{double(column), double(line)};
        const bool data = whole.has_data(column, whole.row_of_line(line));
        const bool covered = a.samples.count(p) != 0 || b.samples.count(p) != 0;
        REQUIRE(covered == data);
        const bool both = a.samples.count(p) != 0 && b.samples.count(p) != 0;
        REQUIRE((!both || column == middle));
      }
    }
    // Where an outline follows the border, its corners there are corners for both.
    for (const auto& [cover, at] : {std::pair(&a, double(middle)), std::pair(&b, 0.0)}) {
      for (const Segment& segment : cover->pslg.segments) {
        const Point p = cover->pslg.points[segment.a.index()];
        const Point q = cover->pslg.points[segment.b.index()];
        if (p.x != at || q.x != at) continue;
        REQUIRE(std::ranges::binary_search(corners, static_cast<std::uint32_t>(p.y)));
        REQUIRE(std::ranges::binary_search(corners, static_cast<std::uint32_t>(q.y)));
      }
    }
  }
}

TEST_CASE("a sample alone on the corner of four parts gets one square") {
  const HeightGrid whole = test::grid_of({".....", ".....", "..1..", ".....", "....."});
  std::size_t parts_with_data = 0;
  for (const std::uint32_t row : {0U, 2U}) {
    for (const std::uint32_t column : {0U, 2U}) {
      GridPart part = part_of(whole, {column, row, 3, 3});
      leave_to_neighbours(part);
      parts_with_data += part.grid.has_any_data();
    }
  }
  CHECK(parts_with_data == 1);
}
