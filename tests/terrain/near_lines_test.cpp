#include "lepp/terrain/near_lines.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/random.hpp"
#include "terrain/grids.hpp"

using namespace lepp;

namespace {

/// In cells, from a to the nearest of many places on cd.
double distance(Point a, Point c, Point d, double aspect) {
  double least = INFINITY;
  for (int i = 0; i <= 200; ++i) {
    const Point p = c + (i / 200.0) * (d - c);
    least = std::min(least, std::max(std::abs(p.x - a.x), std::abs(p.y - a.y) / aspect));
  }
  return least;
}

}  // namespace

TEST_CASE("a segment within a cell of a line is near it, most others are not") {
  constexpr std::uint64_t seed = 3;
  CAPTURE(seed);
  test::Random random(seed);
  const double aspect = 0.7;
  const HeightGrid grid =
      test::grid_of(std::vector<std::string>(90, std::string(120, '1')), aspect);
  std::size_t near = 0, far = 0;
  for (int i = 0; i < 1000; ++i) {
    CAPTURE(i);
    const auto somewhere = [&](double out) {
      return Point{random.real(-out, 119 + out), random.real(-out, 89 + out) * aspect};
    };
    NearLines lines(grid);
    const Point c = somewhere(300), d = somewhere(300);
    lines.add(c, d);
    const Point a = somewhere(0);
    const Point b{std::clamp(a.x + random.between(-3, 3), 0.0, 119.0), a.y};
    const bool is_near = lines.is_near(a, b);
    if (distance(a, c, d, aspect) < 1) REQUIRE(is_near);
    ++(is_near ? near : far);
  }
  CHECK(near > 20);
  CHECK(far > 500);
}

TEST_CASE("a line from far outside to far outside is near what it passes") {
  const HeightGrid grid = test::grid_of(std::vector<std::string>(40, std::string(40, '1')));
  for (const double far : {1e3, 1e9, 1e13, 1e16, 1e20, 1e60}) {
    CAPTURE(far);
    NearLines lines(grid);
    lines.add({-far, 7.5}, {far, 7.5});
    CHECK(lines.is_near({39, 0}, {39, 39}));
    CHECK(lines.is_near({0, 0}, {0, 39}));
    NearLines slanting(grid);
    slanting.add({-far, -far}, {far, far});
    CHECK(slanting.is_near({39, 0}, {39, 39}));
  }
}

TEST_CASE("a line far outside, or of no length, marks no more than it should") {
  const HeightGrid grid = test::grid_of(std::vector<std::string>(40, std::string(40, '1')));
  NearLines lines(grid);
  lines.add({-1e30, -1e30}, {-1e30, 1e30});
  lines.add({50, 0}, {50, 39});
  CHECK(!lines.is_near({0, 0}, {39, 39}));
  lines.add({20, 20}, {20, 20});
  CHECK(lines.is_near({20, 0}, {20, 39}));
  CHECK(!lines.is_near({0, 0}, {5, 0}));
}
