#include "lepp/refine/size_field.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/predicates.hpp"
#include "support/shapes.hpp"

using namespace lepp;

namespace {

std::vector<SizeSource> random_sources(std::mt19937_64& random, int count) {
  std::uniform_real_distribution<double> coordinate(-1, 1), exponent(-8, 0);
  std::vector<SizeSource> sources;
  for (int i = 0; i < count; ++i) {
    sources.push_back({{coordinate(random), coordinate(random)}, std::exp(exponent(random))});
  }
  return sources;
}

}  // namespace

TEST_CASE("a size field is the least of all cones: the tree agrees with a plain loop") {
  const unsigned seed = 5;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(-2, 2);
  for (const int count : {1, 2, 3, 10, 257, 2000}) {
    for (const double grading : {0.0, 0.2, 3.0}) {
      CAPTURE(count);
      CAPTURE(grading);
      const auto sources = random_sources(random, count);
      const SizeField field(sources, grading);
      for (int i = 0; i < 200; ++i) {
        const Point p{coordinate(random), coordinate(random)};
        double least = std::numeric_limits<double>::infinity();
        for (const SizeSource& s : sources) {
          least = std::min(least, s.size + grading * std::sqrt(squared_distance(s.at, p)));
        }
        CHECK(field(p) == doctest::Approx(least).epsilon(1e-14));
      }
    }
  }
}

TEST_CASE("a size field never changes faster than its grading, whatever the sources ask for") {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const SizeField field(random_sources(random, 500), 0.3);
  for (int i = 0; i < 2000; ++i) {
    const Point p{coordinate(random), coordinate(random)},
        q{coordinate(random), coordinate(random)};
    const double change = std::abs(field(p) - field(q));
    CHECK(change <= 0.3 * std::sqrt(squared_distance(p, q)) * (1 + 1e-12) + 1e-15);
  }
}

TEST_CASE("equal places and many sources on one line are no trouble for the tree") {
  std::vector<SizeSource> sources;
  for (int i = 0; i < 1000; ++i) sources.push_back({{static_cast<double>(i % 7), 0}, 1.0 + i});
  const SizeField field(sources, 0.5);
  CHECK(field({0, 0}) == 1);
  CHECK(field({0, 2}) == 2);
  CHECK(field({3, 0}) == 2.5);  // the source at 0, which asks for 1, not its own, which asks for 4
}

TEST_CASE("a size field without sources asks for nothing") {
  CHECK(SizeField({}, 0.5)({1, 2}) == std::numeric_limits<double>::infinity());
}

TEST_CASE("a size field refuses what is no size") {
  CHECK_THROWS_AS(SizeField({{{0, 0}, 0}}, 0.5), InputError);
  CHECK_THROWS_AS(SizeField({{{0, 0}, -1}}, 0.5), InputError);
  CHECK_THROWS_AS(SizeField({{{0, 0}, std::nan("")}}, 0.5), InputError);
  CHECK_THROWS_AS(SizeField({{{0, std::nan("")}, 1}}, 0.5), InputError);
  CHECK_THROWS_AS(SizeField({{{0, 0}, 1}}, -0.1), InputError);
}

TEST_CASE("segments become sources at their middles, a quarter longer than they are") {
  const auto sources = sizes_of_segments(test::unit_square());
  REQUIRE(sources.size() == 4);
  CHECK(sources[0].at == Point{0.5, 0});
  CHECK(sources[0].size == 1.25);
}

TEST_CASE("the least size of sources in a triangle agrees with a plain loop") {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  auto sources = random_sources(random, 300);
  for (std::size_t i = 0; i < sources.size(); i += 2) sources[i].holds_around_it = true;
  const SizeField field(sources, 10);
  int inside = 0;
  for (int i = 0; i < 500; ++i) {
    Point a{coordinate(random), coordinate(random)}, b{coordinate(random), coordinate(random)};
    const Point c{coordinate(random), coordinate(random)};
    if (orient2d(a, b, c) < 0) std::swap(a, b);
    double least = 0.1;
    for (const SizeSource& s : sources) {
      const bool within =
          orient2d(a, b, s.at) >= 0 && orient2d(b, c, s.at) >= 0 && orient2d(c, a, s.at) >= 0;
      if (within && s.holds_around_it) least = std::min(least, s.size);
    }
    CHECK(field.least_within(a, b, c, 0.1) == least);
    if (least < 0.1) ++inside;
  }
  CHECK(inside > 100);
}
