#include "support/oracle_cases.hpp"

#include <cmath>

#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/pslg.hpp"
#include "lepp/geometry/text.hpp"
#include "support/oracle.hpp"
#include "support/random.hpp"

namespace lepp::test {

namespace {

using Points = std::array<Point, 4>;

Points anywhere(Random& random) {
  Points points;
  for (Point& p : points) p = {random.real(-1, 1), random.real(-1, 1)};
  return points;
}

// Multiples of one direction: collinear, and with d on the line too.
Points on_a_line(Random& random) {
  const int dx = random.between(-9, 9), dy = random.between(-9, 9), x = random.between(-50, 50);
  Points points;
  for (Point& p : points) {
    const int t = random.between(-1000, 1000);
    p = {double(x + t * dx), double(3 + t * dy)};
  }
  return points;
}

// The lattice points of the circle x^2 + y^2 = 65^2 with both coordinates not 0, any signs.
Points on_a_circle(Random& random) {
  static constexpr int on[][2] = {{16, 63}, {25, 60}, {33, 56}, {39, 52},
                                  {52, 39}, {56, 33}, {60, 25}, {63, 16}};
  Points points;
  for (Point& p : points) {
    const auto& q = on[random.below(8)];
    const int x = random.one_in(2) ? q[0] : -q[0], y = random.one_in(2) ? q[1] : -q[1];
    p = {double(x), double(y)};
  }
  return points;
}

// a, b, c has a right angle at b; d completes the rectangle, so all four are cocircular.
Points right_angle(Random& random) {
  const int ux = random.between(-30, 30), uy = random.between(-30, 30);
  const int s = random.between(1, 20), t = random.between(1, 20);
  const Point b{double(random.between(-99, 99)), double(random.between(-99, 99))};
  const Point u{double(s * ux), double(s * uy)}, v{double(-t * uy), double(t * ux)};
  return {b + u, b, b + v, b + u + v};
}

// Exponents from all over the supported range, some coordinates 0.
Points wild_exponents(Random& random) {
  Points points;
  const int low = random.between(-140, 150), spread = random.between(1, 50);
  const auto coordinate = [&] {
    if (random.one_in(8)) return 0.0;
    const double x = std::ldexp(1 + random.real(), random.between(low, low + spread - 1));
    return random.one_in(2) ? x : -x;
  };
  for (Point& p : points) {
    p.x = coordinate();
    p.y = coordinate();
  }
  return points;
}

void turn_345(Points& points) {
  for (Point& p : points) p = {0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y};
}

void move_by_a_few_ulps(Points& points, Random& random) {
  for (Point& p : points) {
    if (random.one_in(2)) continue;
    p.x = move_by_ulps(p.x, random.between(-2, 2));
    p.y = move_by_ulps(p.y, random.between(-2, 2));
  }
}

double in_range(double c) { return std::abs(c) < min_coordinate ? 0 : c; }

std::string text(const Points& p) {
  return to_text(p[0]) + " " + to_text(p[1]) + " " + to_text(p[2]) + " " + to_text(p[3]);
}

std::string wrong_predicate(const Points& p) {
  const auto& [a, b, c, d] = p;
  const int turn = exact_orient2d(a, b, c);
  if (orient2d(a, b, c) != turn || orient2d(b, c, a) != turn || orient2d(b, a, c) != -turn) {
    return "orient2d";
  }
  if (dot_sign(a, b, c) != exact_dot_sign(a, b, c)) return "dot_sign";
  if (dot_sign(a, d, b) != exact_dot_sign(a, d, b)) return "dot_sign";
  if (turn == 0) return {};
  const Point left = turn > 0 ? a : b, right = turn > 0 ? b : a;
  const int inside = exact_incircle(left, right, c, d);
  const bool same = incircle(left, right, c, d) == inside && incircle(c, left, right, d) == inside;
  return same ? "" : "incircle";
}

}  // namespace

std::array<Point, 4> predicate_case(std::uint64_t seed) {
  Random random(seed);
  Points points;
  switch (random.below(8)) {
    case 0:
      points = anywhere(random);
      break;
    case 1:
      points = wild_exponents(random);
      break;
    case 2:
    case 3:
      points = on_a_line(random);
      break;
    case 4:
    case 5:
      points = on_a_circle(random);
      break;
    default:
      points = right_angle(random);
      break;
  }
  if (random.one_in(3)) turn_345(points);
  if (random.one_in(3)) {
    const double far = random.one_in(2) ? 1e7 : 1e15;
    const Point shift{far, random.one_in(2) ? far : -0.3 * far};
    for (Point& p : points) p = p + shift;
  }
  if (random.one_in(2)) move_by_a_few_ulps(points, random);
  if (random.one_in(3)) {
    const double scale = std::ldexp(1.0, random.between(-140, 140));
    for (Point& p : points) p = scale * p;
  }
  for (Point& p : points) {
    p = {in_range(p.x), in_range(p.y)};
    if (std::abs(p.x) > max_coordinate) p.x = max_coordinate;
    if (std::abs(p.y) > max_coordinate) p.y = max_coordinate;
  }
  return points;
}

std::optional<std::string> predicate_difference(std::uint64_t seed) {
  const Points p = predicate_case(seed);
  const std::string wrong = wrong_predicate(p);
  if (wrong.empty()) return std::nullopt;
  return wrong + " differs from the oracle, seed " + std::to_string(seed) + ": " + text(p);
}

}  // namespace lepp::test
