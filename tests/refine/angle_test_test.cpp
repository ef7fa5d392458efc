#include "lepp/refine/angle_test.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

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
