#include "lepp/geometry/near_pairs.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "lepp/geometry/segment_intersection.hpp"
#include "support/random.hpp"

using namespace lepp;

namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

struct Visited {
  Pairs pairs;
  std::size_t visits = 0;
};

Visited visited(const std::vector<Strip>& strips) {
  Visited result;
  for_each_near_pair(strips, [&](std::uint32_t i, std::uint32_t j) {
    result.pairs.emplace(i, j);
    ++result.visits;
    return true;
  });
  return result;
}

bool misses_a_pair(const std::vector<Strip>& strips, const Pairs& visited) {
  for (std::uint32_t i = 0; i < strips.size(); ++i) {
    for (std::uint32_t j = i + 1; j < strips.size(); ++j) {
      const Strip &s = strips[i], &t = strips[j];
      if (s.a == s.b && t.a == t.b) continue;
      if (segments_meet(s.a, s.b, t.a, t.b) == SegmentMeeting::apart) continue;
      if (!visited.contains({i, j})) return true;
    }
  }
  return false;
}

// From a circle of radius `inner` outwards, each ending where it likes.
std::vector<Strip> rays(std::size_t count, double inner) {
  test::Random random(7);
  std::vector<Strip> strips;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    const Point direction{std::cos(angle), std::sin(angle)};
    strips.push_back({inner * direction, (inner + random.real(0.5, 1.5)) * direction});
  }
  return strips;
}

}  // namespace

TEST_CASE("near pairs: rays around a small circle, and lines that converge, are parted cheaply") {
  for (const double inner : {1e-3, 1e-6, 1e-9}) {
    CAPTURE(inner);
    CHECK(visited(rays(20'000, inner)).visits < 40 * 20'000);
  }
  std::vector<Strip> converging;
  for (int i = 0; i < 20'000; ++i) converging.push_back({{0, 1e-8 * i}, {1, 5e-5 * i}});
  CHECK(visited(converging).visits < 40 * 20'000);
}

TEST_CASE("near pairs: rays are parted along one of them, and what crosses them is still found") {
  std::vector<Strip> strips = rays(400, 1e-3);
  for (int i = 0; i < 20; ++i) {
    const double r = 1e-3 * std::pow(1.4, i);
    strips.push_back({{-r, 0.3 * r}, {1.1 * r, 0.7 * r}});
  }
  const Visited found = visited(strips);
  CHECK(!misses_a_pair(strips, found.pairs));
}

TEST_CASE("near pairs: pieces within rounding of each other cost no more than all pairs do") {
  test::Random random(8);
  const auto close = [&] { return test::move_by_ulps(-1, random.between(-16, 16)); };
  std::vector<Strip> strips;
  for (int i = 0; i < 14; ++i) {
    const double x = close(), y = close();  // in this order, whatever the compiler
    strips.push_back({{x, -1}, {-1, y}});
  }
  for (int i = 0; i < 30; ++i) strips.push_back({{-1, -1}, {-1, -1}, {0x1p-52, 0x1p-52}});
  const Visited found = visited(strips);
  CHECK(found.visits < 10 * strips.size() * strips.size());
  CHECK(!misses_a_pair(strips, found.pairs));
}

TEST_CASE(
    "near pairs: segments that overlap along a line, with points on them, are no copies of cells") {
  std::vector<Strip> strips;
  for (int i = 0; i < 60; ++i) strips.push_back({{-1.0 - i, 0}, {601.0 + i, 0}});
  for (int i = 0; i < 600; ++i) strips.push_back({{i + 0.5, 0}, {i + 0.5, 0}});
  const Visited result = visited(strips);
  CHECK(!misses_a_pair(strips, result.pairs));
  CHECK(result.visits < 10 * result.pairs.size());  // was a thousand times
}
