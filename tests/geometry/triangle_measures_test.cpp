#include "lepp/geometry/triangle_measures.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace lepp;
using doctest::Approx;

namespace {

constexpr double degree = std::numbers::pi / 180;

// A triangle with the angles alpha at a and beta at b, and |ab| = 1.
std::array<Point, 3> with_angles(double alpha_deg, double beta_deg) {
  const double gamma = (180 - alpha_deg - beta_deg) * degree;
  const double ac = std::sin(beta_deg * degree) / std::sin(gamma);
  return {
      Point{0, 0}, {1, 0}, {ac * std::cos(alpha_deg * degree), ac * std::sin(alpha_deg * degree)}};
}

}  // namespace

TEST_CASE("signed_area is positive counter-clockwise and exact far from the origin") {
  CHECK(signed_area({0, 0}, {2, 0}, {0, 1}) == 1);
  CHECK(signed_area({0, 0}, {0, 1}, {2, 0}) == -1);
  const Point far{4503599627370496, 4503599627370496};  // 2^52: products would need 105 bits
  CHECK(signed_area(far, far + Point{1, 0}, far + Point{0, 1}) == 0.5);
}

TEST_CASE("angles_deg gives the angles at a, b and c, for either orientation") {
  for (const auto& given : {std::pair{30.0, 60.0}, {90.0, 45.0}, {120.0, 1.0}, {0.001, 90.0}}) {
    const auto alpha = given.first, beta = given.second;
    CAPTURE(alpha);
    const auto [a, b, c] = with_angles(alpha, beta);
    const auto turned_left = angles_deg(a, b, c), turned_right = angles_deg(a, c, b);
    CHECK(turned_left[0] == Approx(alpha).epsilon(1e-12));
    CHECK(turned_left[1] == Approx(beta).epsilon(1e-12));
    CHECK(turned_left[2] == Approx(180 - alpha - beta).epsilon(1e-12));
    CHECK(turned_right[1] == turned_left[2]);
    CHECK(turned_right[0] == turned_left[0]);
  }
}

TEST_CASE("a right angle on whole coordinates is exactly 90 degrees") {
  CHECK(angles_deg({3, 4}, {0, 0}, {-4, 3})[1] == 90);
  CHECK(angles_deg({0, 0}, {1, 0}, {0, 1})[0] == 90);
}

TEST_CASE("the circumcenter is equally far from the corners, up to some ulp") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(1, 60), offset(-1e3, 1e3);
  for (int i = 0; i < 10'000; ++i) {
    auto [a, b, c] = with_angles(angle(random), 1.9 * angle(random));
    const Point shift{offset(random), offset(random)};
    a = a + shift, b = b + shift, c = c + shift;
    const Point center = circumcenter(a, b, c);
    const double radius = std::sqrt(squared_distance(center, a));
    const double largest_angle = std::ranges::max(angles_deg(a, b, c)) * degree;
    const double allowed = std::numeric_limits<double>::epsilon() *
                           (2e3 + 8 * radius / std::sin(largest_angle));  // place, radius
    CHECK(std::abs(std::sqrt(squared_distance(center, b)) - radius) < allowed);
    CHECK(std::abs(std::sqrt(squared_distance(center, c)) - radius) < allowed);
  }
  CHECK(circumcenter({0, 0}, {4, 0}, {0, 2}) == Point{2, 1});
}

TEST_CASE("the circumcenter does not depend on which corner comes first") {
  const Point a{0.1, 0.7}, b{3.3, -0.2}, c{1.9, 2.6};
  CHECK(circumcenter(a, b, c) == circumcenter(b, c, a));
  CHECK(circumcenter(a, b, c) == circumcenter(c, a, b));
}

TEST_CASE("squared_cos_of_smallest_angle orders triangles by their smallest angle") {
  double previous = 2;
  for (const double smallest : {0.01, 1.0, 20.0, 29.999999, 30.0, 45.0, 59.0}) {
    CAPTURE(smallest);
    const auto [a, b, c] = with_angles(smallest, 60);
    const double cos = std::cos(smallest * degree);
    for (const double value :
         {squared_cos_of_smallest_angle(a, b, c), squared_cos_of_smallest_angle(b, c, a),
          squared_cos_of_smallest_angle(c, a, b)}) {
      CHECK(value == Approx(cos * cos).epsilon(1e-12));
      CHECK(value < previous);
    }
    previous = squared_cos_of_smallest_angle(a, b, c);
  }
}

TEST_CASE("cotangent is dot over cross") {
  const Point a{2, 1}, apex{-1, 0.5}, b{0.25, 3};
  const Point u = a - apex, w = b - apex;
  CHECK(cotangent(a, apex, b) == dot(u, w) / cross(u, w));
  CHECK(cotangent(b, apex, a) == cotangent(a, apex, b));
  CHECK(cotangent({1, 0}, {0, 0}, {0, 3}) == 0);
  CHECK(cotangent({1, 0}, {0, 0}, {2, 2}) == 1);
  CHECK(cotangent({1, 0}, {0, 0}, {-2, 2}) == -1);
}

TEST_CASE("is_below_60_deg and is_below_45_deg part the angles there, on both sides of a ray") {
  for (const double angle : {0.0, 1.0, 44.999999, 45.000001, 59.999999, 60.000001, 90.0, 179.0}) {
    CAPTURE(angle);
    for (const double sign : {1.0, -1.0}) {
      const Point b{2 * std::cos(angle * degree), sign * 2 * std::sin(angle * degree)};
      CHECK(is_below_60_deg({1, 0}, {0, 0}, b) == (angle < 60));
      CHECK(is_below_45_deg({1, 0}, {0, 0}, b) == (angle < 45));
    }
  }
  CHECK_FALSE(is_below_45_deg({5, 0}, {0, 0}, {3, 3}));  // exactly 45
}
