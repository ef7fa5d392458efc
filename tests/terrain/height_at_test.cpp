#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "lepp/terrain/terrain_domain.hpp"
#include "support/random.hpp"
#include "terrain/grids.hpp"

using namespace lepp;
using test::grid_of;

TEST_CASE("at a sample the height is the sample's, bit for bit") {
  for (const double aspect : {1.0, 0.3, 74.4 / 92.6}) {
    CAPTURE(aspect);
    HeightGrid grid = grid_of({"1.3.", "23.5", "4567"}, aspect);
    for (std::size_t i = 0; i < grid.size(); ++i) grid.heights.set(i, 0.1 * grid.heights[i]);
    for (std::uint32_t row = 0; row < grid.rows; ++row) {
      for (std::uint32_t column = 0; column < grid.columns; ++column) {
        if (!grid.has_data(column, row)) continue;
        CHECK(height_at(grid, grid.sample(column, grid.rows - 1 - row)) ==
              grid.height(column, row));
      }
    }
  }
}

TEST_CASE("between four samples the height is bilinear, also on the rim") {
  const HeightGrid grid = grid_of({"26", "48"}, 2);  // 4 8 is the southern line
  CHECK(height_at(grid, {0.5, 1}) == 5);
  CHECK(height_at(grid, {0.25, 0}) == 5);
  CHECK(height_at(grid, {1, 0.5}) == 7.5);
  CHECK(height_at(grid, {0.25, 0.5}) == 0.75 * 5 + 0.25 * 3);
}

TEST_CASE("between three samples the height is that of their plane, beyond them of the nearest") {
  const auto at = [](std::vector<std::string> rows, Point p) {
    return height_at(grid_of(rows), p);
  };
  CHECK(at({"3.", "12"}, {0.25, 0.5}) == 1 + 0.25 + 1);
  CHECK(at({"34", ".2"}, {0.75, 0.5}) == 4 - 0.25 - 1);
  CHECK(at({".4", "12"}, {0.75, 0.5}) == 2 - 0.25 + 1);
  CHECK(at({"34", "1."}, {0.25, 0.5}) == 3 + 0.25 - 1);
  CHECK(at({"3.", "12"}, {0.9, 0.6}) == 2);
  CHECK(at({"3.", "12"}, {0.6, 0.9}) == 3);
}

TEST_CASE("on a side between two samples the height is linear whatever lies beside it") {
  CHECK(height_at(grid_of({"..", "13"}), {0.5, 0}) == 2);
  CHECK(height_at(grid_of({"3.", "1."}), {0, 0.25}) == 1.5);
}

TEST_CASE("far from all data the height is that of the nearest sample, as a full search finds it") {
  constexpr std::uint64_t seed = 7;
  CAPTURE(seed);
  test::Random random(seed);
  for (int i = 0; i < 300; ++i) {
    CAPTURE(i);
    HeightGrid grid = grid_of(std::vector<std::string>(9, std::string(7, '.')), i % 2 ? 1 : 0.4);
    for (int k = 0; k < 3; ++k) grid.heights.set(random.below(63), k);
    const Point p{random.real(-1, 7), random.real(-1, 9) * grid.aspect()};
    const Point inside{std::clamp(p.x, 0.0, 6.0), std::clamp(p.y, 0.0, 8 * grid.aspect())};
    double nearest = INFINITY;
    for (std::uint32_t line = 0; line < 9; ++line) {
      for (std::uint32_t column = 0; column < 7; ++column) {
        if (!grid.has_data(column, grid.row_of_line(line))) continue;
        nearest = std::min(nearest, squared_distance(inside, grid.sample(column, line)));
      }
    }
    const double height = height_at(grid, p);
    bool is_nearest = false;
    for (std::uint32_t line = 0; line < 9; ++line) {
      for (std::uint32_t column = 0; column < 7; ++column) {
        is_nearest |= grid.height(column, grid.row_of_line(line)) == height &&
                      squared_distance(inside, grid.sample(column, line)) <= nearest * 1.0000001;
      }
    }
    CHECK(is_nearest);
  }
  CHECK(std::isnan(height_at(grid_of({"...", "..."}), {1, 1})));
}
