#include "lepp/refine/angle_test.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/triangle_measures.hpp"

using namespace lepp;

TEST_CASE("the test without acos agrees with the angle in degrees") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (const double bound : {1.0, 20.0, 30.0, 45.0}) {
    const AngleTest test(bound);
    for (int i = 0; i < 1000; ++i) {
      Point a{coordinate(random), coordinate(random)}, b{coordinate(random), coordinate(random)},
          c{coordinate(random), coordinate(random)};
      const auto angles = angles_deg(a, b, c);
      const double smallest = std::ranges::min(angles);
      if (std::abs(smallest - bound) < 1e-6) continue;
      CHECK(test.is_below(a, b, c) == (smallest < bound));
      CHECK(AngleTest::badness(a, b, c) == doctest::Approx(AngleTest::squared_cos(smallest)));
    }
  }
}

TEST_CASE("a bound of 0 asks for nothing, and an angle that is the bound reaches it") {
  CHECK_FALSE(AngleTest(0).is_below({0, 0}, {1, 0}, {2, 0}));
  CHECK_FALSE(AngleTest(45).is_below({0, 0}, {1, 0}, {0, 1}));
  CHECK(AngleTest(45.001).is_below({0, 0}, {1, 0}, {0, 1}));
}

TEST_CASE("the largest angle of a needle is found whichever of its sides rounds to the longest") {
  const Point o{0.5, 0.3}, p{0.5000000005, 0.6000000000000001}, q{0.49999999949999996, 0.6};
  const AngleTest right(0, 90);
  const bool obtuse = is_obtuse(o, p, q) || is_obtuse(p, q, o) || is_obtuse(q, o, p);
  REQUIRE(obtuse);
  CHECK(right.is_above(o, p, q));
  CHECK(right.is_above(p, q, o));
  CHECK(right.is_above(q, o, p));
}

TEST_CASE("the largest angle is told apart from its bound up to nearly 180 degrees") {
  for (const double bound : {91.0, 120.0, 179.0, 179.9999, 179.99999}) {
    CAPTURE(bound);
    const double unit = std::numbers::pi / 180;
    for (const double off : {-2e-9, 2e-9}) {
      const double rest = (180 - bound - off) * unit;  // the angle at the origin is bound + off
      const Point tip{-std::cos(rest), std::sin(rest)};
      CHECK(AngleTest(0, bound).is_above({1, 0}, tip, {0, 0}) == (off > 0));
    }
  }
}
