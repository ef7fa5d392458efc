#include "lepp/terrain/star_filling.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "lepp/geometry/predicates.hpp"
#include "support/random.hpp"

using namespace lepp;

TEST_CASE("StarFilling: the Delaunay triangles of a star-shaped hole") {
  constexpr std::uint64_t seed = 21;
  CAPTURE(seed);
  test::Random random(seed);
  int filled = 0;
  for (int run = 0; run < 500; ++run) {
    StarFilling filling;
    const std::size_t n = 3 + random.below(8);
    for (std::size_t i = 0; i < n; ++i) {
      const double part = (static_cast<double>(i) + 0.8 * random.real()) / static_cast<double>(n);
      const double turn = 2 * std::numbers::pi * part;
      const double radius = random.real(0.6, 1);  // a hole of a Delaunay triangulation is no comb
      filling.corners().push_back({{radius * std::cos(turn), radius * std::sin(turn)}, {}});
    }
    if (!filling.fill(AngleTest(0))) continue;
    ++filled;
    REQUIRE(filling.triangles().size() == n - 2);
    double area = 0, whole = 0;
    for (std::size_t i = 0; i < n; ++i) {
      whole += cross(filling.corners()[i].place, filling.corners()[(i + 1) % n].place);
    }
    for (const auto& t : filling.triangles()) {
      const Point a = filling.corners()[t[0]].place, b = filling.corners()[t[1]].place,
                  c = filling.corners()[t[2]].place;
      REQUIRE(orient2d(a, b, c) > 0);
      area += cross(b - a, c - a);
    }
    REQUIRE(area == doctest::Approx(whole));
  }
  CHECK(filled > 400);
}

TEST_CASE("StarFilling: refuses where an angle would be below the bound") {
  StarFilling filling;
  for (const Point p : {Point{0, 0}, Point{4, 0}, Point{4, 1}, Point{0, 1}}) {
    filling.corners().push_back({p, {}});
  }
  CHECK(filling.fill(AngleTest(14)));  // atan(1 / 4) is 14.04 degrees
  CHECK(!filling.fill(AngleTest(14.1)));
}
