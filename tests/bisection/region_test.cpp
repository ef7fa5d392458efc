#include "lepp/bisection/region.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "lepp/geometry/predicates.hpp"

using namespace lepp;

namespace {

constexpr std::array<Point, 3> triangle{Point{0, 0}, Point{4, 0}, Point{0, 4}};

}  // namespace

TEST_CASE("a disc meets a triangle that it touches, holds, or lies in") {
  CHECK(meets(Disc{{1, 1}, 0.1}, triangle));
  CHECK(meets(Disc{{1, 1}, 100}, triangle));
  CHECK(meets(Disc{{-1, 2}, 1}, triangle));
  CHECK_FALSE(meets(Disc{{-1, 2}, 0.999}, triangle));
  CHECK(meets(Disc{{3, 3}, std::sqrt(2.0) + 1e-12}, triangle));
  CHECK_FALSE(meets(Disc{{3, 3}, std::sqrt(2.0) - 1e-12}, triangle));
  CHECK(meets(Disc{{1, 1}, 0}, triangle));
}

TEST_CASE("a box meets a triangle that it touches, holds, lies in, or crosses") {
  CHECK(meets(Box{{1, 1}, {1.5, 1.5}}, triangle));
  CHECK(meets(Box{{-9, -9}, {9, 9}}, triangle));
  CHECK(meets(Box{{-1, 1}, {9, 2}}, triangle));
  CHECK(meets(Box{{4, -1}, {5, 0}}, triangle));
  CHECK(meets(Box{{2, 2}, {3, 3}}, triangle));
  CHECK_FALSE(meets(Box{{2.1, 2.1}, {3, 3}}, triangle));
}

TEST_CASE("a polygon meets a triangle by its sides, its corners, or its inside; holes do not") {
  const PolygonArea around{{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}};
  CHECK(meets(around, triangle));
  CHECK(meets(PolygonArea{{{1, 1}, {1.2, 1}, {1, 1.2}}}, triangle));
  CHECK(meets(PolygonArea{{{4, 0}, {5, 0}, {5, 1}}}, triangle));
  CHECK_FALSE(meets(PolygonArea{{{4.5, 0}, {5, 0}, {5, 1}}}, triangle));
  // Twice around the triangle: inside an even number of times.
  PolygonArea twice = around;
  for (const Point p :
       {Point{-9, -9}, Point{-8, -8}, Point{8, -8}, Point{8, 8}, Point{-8, 8}, Point{-8, -8}}) {
    twice.corners.push_back(p);
  }
  CHECK_FALSE(meets(twice, triangle));
}

TEST_CASE("a region of either kind that holds a random point of the triangle meets it") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> part(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const double u = part(random), v = part(random) * (1 - u);
    const Point p{4 * u, 4 * v};
    const Point to{part(random), part(random)};
    CHECK(meets(Disc{p + to, 1.000001 * std::sqrt(dot(to, to))}, triangle));
    CHECK(meets(Box{p, p + to}, triangle));
    CHECK(meets(PolygonArea{{p, p + to, p + Point{-to.y, to.x}}}, triangle));
  }
}

TEST_CASE("the distance from a region is 0 inside and that of its nearest point outside") {
  const Disc disc{{1, 1}, 2};
  const Box box{{0, 0}, {2, 1}};
  const PolygonArea polygon{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}};
  CHECK(distance(disc, {2, 2}) == 0);
  CHECK(distance(disc, {1, 4}) == 1);
  for (const Region& region : {Region(box), Region(polygon)}) {
    CHECK(distance(region, {1, 0.5}) == 0);
    CHECK(distance(region, {5, 5}) == 5);
    CHECK(distance(region, {1, -3}) == 3);
  }
}
