#include "lepp/bisection/region.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "lepp/geometry/place_on_segment.hpp"
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
  std::vector<Point> twice = around.corners();
  for (const Point p :
       {Point{-9, -9}, Point{-8, -8}, Point{8, -8}, Point{8, 8}, Point{-8, 8}, Point{-8, -8}}) {
    twice.push_back(p);
  }
  CHECK_FALSE(meets(PolygonArea(twice), triangle));
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

TEST_CASE("any closed chain: inside by counting all sides, and as far away as its nearest side") {
  std::mt19937_64 random(9);
  std::uniform_int_distribution<int> coordinate(0, 12);  // many corners on the rays
  const auto some_place = [&] {
    return Point{static_cast<double>(coordinate(random)), static_cast<double>(coordinate(random))};
  };
  for (std::size_t n = 3; n < 60; ++n) {
    CAPTURE(n);
    std::vector<Point> corners(n);
    for (Point& p : corners) p = some_place();
    const PolygonArea polygon(corners);
    for (int i = 0; i < 40; ++i) {
      const Point p = i % 2 == 0 ? some_place() : 0.5 * (some_place() + some_place());
      bool inside = false;
      double least = 1e300;
      for (std::size_t k = 0; k < n; ++k) {
        const Point a = corners[k], b = corners[(k + 1) % n];
        least = std::min(least, nearest_place(a, b, p).squared_distance);
        if ((a.y > p.y) == (b.y > p.y)) continue;
        inside ^= (a.y < b.y ? orient2d(a, b, p) : orient2d(b, a, p)) > 0;
      }
      CHECK(polygon.contains(p) == inside);
      CHECK(polygon.squared_distance_from_sides(p) == doctest::Approx(least).epsilon(1e-12));
      const auto count = [&](auto asked) {
        std::size_t sides = 0;
        asked([&](Point a, Point b) {
          const auto [left, right] = std::minmax(a.x, b.x);
          const auto [bottom, top] = std::minmax(a.y, b.y);
          sides += right >= p.x && left <= p.x + 2 && top >= p.y && bottom <= p.y + 2 ? 1 : 0;
          return false;
        });
        return sides;
      };
      CHECK(count([&](auto f) {
              polygon.any_side_near(p, p + Point{2, 2}, f);
            }) == count([&](auto f) {
              for (std::size_t k = 0; k < n; ++k) f(corners[k], corners[(k + 1) % n]);
            }));
    }
  }
}

TEST_CASE("few sides of a long chain are looked at") {
  constexpr std::size_t n = 20000;
  std::vector<Point> coast;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::acos(-1.0) * static_cast<double>(i) / n;
    const double r = 1 + 0.1 * std::sin(100 * angle);
    coast.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  const PolygonArea polygon(coast);
  std::size_t looked_at = 0;
  for (const Point& p : coast) {
    polygon.any_side_near(p, p + Point{1e-3, 1e-3}, [&](Point, Point) {
      ++looked_at;
      return false;
    });
  }
  CHECK(looked_at < 20 * n);
}
