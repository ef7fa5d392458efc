#include "lepp/refine/feasible_place.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/triangle_measures.hpp"

using namespace lepp;

namespace {

Star random_link(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform;
  Star star;
  const int n = 4 + static_cast<int>(random() % 5);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5 * uniform(random)) / n;
    const double radius = 0.6 + 0.6 * uniform(random);
    const Point p{5 + radius * std::cos(angle), 7 + radius * std::sin(angle)};
    star.link.push_back({{}, p, random() % 8 == 0});
  }
  return star;
}

bool is_good(const Star& star, Point p, double bound) {
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Point a = star.from(i), b = star.to(i);
    if (orient2d(a, b, p) <= 0) return false;
    const auto angles = angles_deg(p, a, b);
    if (std::min({angles[0], angles[1], angles[2]}) < bound) return false;
    if (star.link[i].constrained && is_obtuse(a, p, b)) return false;
  }
  return true;
}

// How many of the places on a grid are good.
int good_places(const Star& star, double bound) {
  int good = 0;
  for (int i = -50; i <= 50; ++i) {
    for (int j = -50; j <= 50; ++j) good += is_good(star, {5 + i / 40.0, 7 + j / 40.0}, bound);
  }
  return good;
}

}  // namespace

TEST_CASE("a place that is found is good, and where many are good one is found") {
  std::mt19937_64 random(77);
  for (const double bound : {15.0, 25.0, 30.0, 36.0}) {
    FeasiblePlace place(bound);
    int found = 0, missed = 0;
    for (int i = 0; i < 150; ++i) {
      CAPTURE(i);
      const Star star = random_link(random);
      const int good = good_places(star, bound);
      const auto p = place.find(star, {5, 7});
      if (p) {
        ++found;
        CHECK(is_good(star, *p, bound));
      } else if (good > 20) {
        ++missed;  // only diametral circles, which are not convex, can hide a place
        bool any_constrained = false;
        for (const auto& e : star.link) any_constrained = any_constrained || e.constrained;
        CHECK(any_constrained);
      }
      if (good == 0 && p) CHECK(is_good(star, *p, bound));
    }
    CAPTURE(bound);
    CHECK(found > 3);
    CHECK(missed <= 5);
  }
}

TEST_CASE("a star with more edges than the bound allows has no place") {
  Star star;
  for (int i = 0; i < 13; ++i) {
    const double angle = 2 * std::numbers::pi * i / 13;
    star.link.push_back({{}, {std::cos(angle), std::sin(angle)}, false});
  }
  CHECK_FALSE(FeasiblePlace(30).find(star, {0, 0}));
  CHECK(FeasiblePlace(27).find(star, {0, 0}));
}
