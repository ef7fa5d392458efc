#include "lepp/geometry/predicates.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <random>

#include "support/real_inputs.hpp"

using namespace lepp;

namespace {

__extension__ typedef __int128 Wide;

int sign(Wide x) { return (x > 0) - (x < 0); }

// Integer coordinates, so that 128 bits hold every determinant: an oracle without floating point.
struct IntegerPoint {
  std::int64_t x, y;
  Point scaled(double s) const { return {s * static_cast<double>(x), s * static_cast<double>(y)}; }
};

int oracle_orient(IntegerPoint a, IntegerPoint b, IntegerPoint c) {
  return sign(Wide(a.x - c.x) * (b.y - c.y) - Wide(a.y - c.y) * (b.x - c.x));
}

int oracle_dot(IntegerPoint a, IntegerPoint apex, IntegerPoint b) {
  return sign(Wide(a.x - apex.x) * (b.x - apex.x) + Wide(a.y - apex.y) * (b.y - apex.y));
}

int oracle_incircle(IntegerPoint a, IntegerPoint b, IntegerPoint c, IntegerPoint d) {
  const auto lift = [&](IntegerPoint p) {
    return Wide(p.x - d.x) * (p.x - d.x) + Wide(p.y - d.y) * (p.y - d.y);
  };
  const auto cross = [&](IntegerPoint p, IntegerPoint q) {
    return Wide(p.x - d.x) * (q.y - d.y) - Wide(p.y - d.y) * (q.x - d.x);
  };
  return sign(lift(a) * cross(b, c) + lift(b) * cross(c, a) + lift(c) * cross(a, b));
}

IntegerPoint near_line(std::mt19937_64& random, std::int64_t size) {
  std::uniform_int_distribution<std::int64_t> along(-size, size), off(-1, 1);
  const std::int64_t t = along(random);
  return {3 * t + off(random), 4 * t + off(random)};
}

// The twelve lattice points on the circle of radius 5, scaled up, and pushed by at most one.
IntegerPoint near_circle(std::mt19937_64& random, std::int64_t size) {
  static constexpr std::int64_t on[12][2] = {{5, 0},   {4, 3},  {3, 4},  {0, 5},
                                             {-3, 4},  {-4, 3}, {-5, 0}, {-4, -3},
                                             {-3, -4}, {0, -5}, {3, -4}, {4, -3}};
  const auto& p = on[random() % 12];
  std::uniform_int_distribution<std::int64_t> off(-1, 1);
  const bool push = random() % 2 == 0;
  return {size * p[0] + (push ? off(random) : 0), size * p[1] + (push ? off(random) : 0)};
}

}  // namespace

TEST_CASE("this build does floating-point arithmetic as the predicates need it") {
  CHECK(predicates_self_test());
}

TEST_CASE("orient2d and dot_sign equal an integer oracle near a line, at any scale") {
  const unsigned seed = 20261;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int i = 0; i < 200'000; ++i) {
    const std::int64_t size = std::int64_t{1} << (random() % 45);
    const IntegerPoint a = near_line(random, size), b = near_line(random, size),
                       c = near_line(random, size);
    const double scale = std::ldexp(1.0, static_cast<int>(random() % 200) - 100);
    const Point p = a.scaled(scale), q = b.scaled(scale), r = c.scaled(scale);
    REQUIRE(orient2d(p, q, r) == oracle_orient(a, b, c));
    REQUIRE(dot_sign(p, q, r) == oracle_dot(a, b, c));
    REQUIRE(orient2d(q, p, r) == -orient2d(p, q, r));
  }
}

TEST_CASE("incircle equals an integer oracle near a circle, at any scale") {
  const unsigned seed = 20262;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int i = 0; i < 200'000; ++i) {
    const std::int64_t size = std::int64_t{1} << (random() % 26);
    const IntegerPoint a = near_circle(random, size), b = near_circle(random, size),
                       c = near_circle(random, size), d = near_circle(random, size);
    const double scale = std::ldexp(1.0, static_cast<int>(random() % 100) - 50);
    REQUIRE(incircle(a.scaled(scale), b.scaled(scale), c.scaled(scale), d.scaled(scale)) ==
            oracle_incircle(a, b, c, d));
  }
}

TEST_CASE("a right angle is not obtuse, one ulp more is") {
  const Point a{1, 0}, apex{0, 0}, b{0, 1};
  CHECK_FALSE(is_obtuse(a, apex, b));
  CHECK(is_obtuse(a, apex, {std::nextafter(0.0, -1.0) * 0x1p+900, 1}));
  CHECK(is_obtuse(a, {0x1p-60, 0x1p-60}, b));
}

TEST_CASE("predicates: published hard cases have the published sign") {
  const auto file = test::real_input("predicates/orient2d.txt");
  if (!file) return;
  std::ifstream in(*file);
  int checked = 0;
  double number = 0, ax = 0, ay = 0, bx = 0, by = 0, cx = 0, cy = 0;
  int expected = 0;
  while (in >> number >> ax >> ay >> bx >> by >> cx >> cy >> expected) {
    CHECK(orient2d({ax, ay}, {bx, by}, {cx, cy}) == expected);
    ++checked;
  }
  CHECK(checked > 100);
}
