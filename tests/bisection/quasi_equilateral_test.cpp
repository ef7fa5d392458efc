// Theorem 1 (c) of [rivara1999]: bisecting all triangles again and again covers more and more of
// the area with quasi-equilateral triangles. The paper does not say which triangles those are; here
// they are the shapes that come back (docs/algorithms/bisection.md), all conditions on squared
// lengths:
//
//            c               sides a <= b <= |pq|, m the median on pq
//          / | \             a and b are the longest edges of the halves:  a >= m, 2 a >= |pq|
//       b /  |m \ a          and m is the longest edge of the two triangles in the middle,
//        / \ | / \           which the cuts of b and a leave beside two that are similar to
//       p----+----q          the whole:  2 m >= b
//
// Then the middle ones, cut along m, are similar to the halves again: four shapes, and no others.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "bisection/random_forest.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

// Exact: coordinates are integers below 2^26.
bool is_quasi_equilateral(const std::array<Point, 3>& corners) {
  const auto squared = [&](std::size_t i, std::size_t j) {
    return static_cast<std::int64_t>(squared_distance(corners[i], corners[j]));
  };
  std::array sides{squared(0, 1), squared(1, 2), squared(2, 0)};
  std::ranges::sort(sides);
  const auto [a, b, c] = sides;
  const std::int64_t m4 = 2 * (a + b) - c;  // 4 m^2
  return 4 * a >= m4 && 4 * a >= c && m4 >= b;
}

double twice_area(const std::array<Point, 3>& p) { return cross(p[1] - p[0], p[2] - p[0]); }

double covered(const Mesh& mesh) {
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto corners = mesh.corners(TriangleId(t));
    if (is_quasi_equilateral(corners)) area += twice_area(corners);  // exact: integers below 2^53
  }
  return area;
}

// Bisects all triangles; what was covered before is covered after. The part of `whole` at the end.
double cover(Forest& forest, int rounds, double whole) {
  double before = covered(forest.mesh());
  for (int i = 0; i < rounds; ++i) {
    forest.bisect(all_triangles(forest.mesh()));
    const double after = covered(forest.mesh());
    CHECK(after >= before);
    before = after;
  }
  CHECK(before <= whole);
  return before / whole;
}

Point random_point(std::mt19937_64& random) {
  std::uniform_int_distribution<int> coordinate(0, 63);
  constexpr double scale = 1 << 20;
  return {scale * coordinate(random), scale * coordinate(random)};
}

}  // namespace

TEST_CASE("what is quasi-equilateral, and what each of the three conditions leaves out") {
  constexpr double s = 1 << 20;
  CHECK(is_quasi_equilateral({Point{0, 0}, {2 * s, 0}, {s, s}}));  // right isosceles
  CHECK(is_quasi_equilateral({Point{0, 0}, {8 * s, 0}, {4 * s, 7 * s}}));
  CHECK(is_quasi_equilateral({Point{0, 0}, {6 * s, 0}, {2 * s, 3 * s}}));
  CHECK_FALSE(is_quasi_equilateral({Point{0, 0}, {4 * s, 0}, {4 * s, s}}));       // 2 a < c
  CHECK_FALSE(is_quasi_equilateral({Point{0, 0}, {10 * s, 0}, {5 * s, 2 * s}}));  // 2 m < b
  CHECK_FALSE(is_quasi_equilateral({Point{0, 0}, {10 * s, 0}, {8 * s, 6 * s}}));  // a < m
}

TEST_CASE("Theorem 1 (c): in 300 random triangles the covered area never falls, and grows") {
  std::mt19937_64 random(21);
  double sum = 0, at_first = 0;
  int triangles = 0;
  while (triangles < 300) {
    CAPTURE(triangles);
    std::array corners{random_point(random), random_point(random), random_point(random)};
    if (twice_area(corners) < 0) std::swap(corners[0], corners[1]);
    if (twice_area(corners) == 0) continue;
    const auto& [a, b, c] = corners;
    Forest forest(constrained_delaunay(polygon({a.x, a.y, b.x, b.y, c.x, c.y})).mesh);
    at_first += is_quasi_equilateral(corners) ? 1 : 0;
    sum += cover(forest, 8, twice_area(corners));
    ++triangles;
  }
  CHECK(at_first < 0.3 * triangles);
  CHECK(sum > 0.85 * triangles);
}

TEST_CASE("Theorem 1 (c): in random meshes, where neighbours have to be cut as well") {
  std::mt19937_64 random(22);
  for (int i = 0; i < 20; ++i) {
    CAPTURE(i);
    const Mesh start = integer_mesh(random, 1 + i % 7);
    constexpr double side = 63.0 * (1 << 20);
    Forest forest(start);
    CHECK(cover(forest, 5, 2 * side * side) > 0.8);
  }
}
