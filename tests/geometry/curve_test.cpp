#include "lepp/geometry/curve.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace lepp;

namespace {

double distance(Point a, Point b) { return std::sqrt(squared_distance(a, b)); }

EllipseArc circle(Point center, double radius, double start, double sweep) {
  return {center, {radius, 0}, {0, radius}, start, sweep};
}

/// y = x^3 for x from -1 to 1, in two pieces of different width.
Curve cubic_parabola() {
  const auto piece = [](double a, double b) {
    // control points of x^3 on [a, b]: the blossom of the cubic
    return std::array<Point, 4>{Point{a, a * a * a}, Point{(2 * a + b) / 3, a * a * b},
                                Point{(a + 2 * b) / 3, a * b * b}, Point{b, b * b * b}};
  };
  return CubicPieces{{0, 0.25, 1}, {piece(-1, -0.5), piece(-0.5, 1)}};
}

CurvePiece piece_of(const Curve& curve, double t_a, double t_b) {
  return {point_at(curve, t_a), point_at(curve, t_b), t_a, t_b};
}

}  // namespace

TEST_CASE("a point of an arc lies on its circle and at its angle") {
  const Curve arc = circle({3, -2}, 5, 0.25, 4);
  for (const double t : {0.0, 0.125, 0.5, 0.9, 1.0}) {
    CAPTURE(t);
    const Point p = point_at(arc, t);
    CHECK(distance(p, {3, -2}) == doctest::Approx(5).epsilon(1e-15));
    CHECK(p.x == doctest::Approx(3 + 5 * std::cos(0.25 + 4 * t)).epsilon(1e-15));
    CHECK(p.y == doctest::Approx(-2 + 5 * std::sin(0.25 + 4 * t)).epsilon(1e-15));
  }
}

TEST_CASE("cubic pieces give the polynomial they stand for, across knots too") {
  const Curve curve = cubic_parabola();
  for (const double t : {0.0, 0.1, 0.25, 0.26, 0.5, 1.0}) {
    CAPTURE(t);
    const Point p = point_at(curve, t);
    CHECK(p.x == doctest::Approx(-1 + 2 * t).epsilon(1e-15));
    CHECK(p.y == doctest::Approx(p.x * p.x * p.x).epsilon(1e-14));
  }
}

TEST_CASE("the derivative agrees with a central difference") {
  const double h = 1e-6;
  for (const Curve& curve : {Curve(circle({1, 2}, 3, -1, -2.5)), cubic_parabola(),
                             Curve(EllipseArc{{0, 0}, {2, 1}, {-1, 1}, 0.5, 1})}) {
    for (const double t : {0.1, 0.4, 0.8}) {
      CAPTURE(t);
      const Point difference = 0.5 / h * (point_at(curve, t + h) - point_at(curve, t - h));
      CHECK(derivative_at(curve, t).x == doctest::Approx(difference.x).epsilon(1e-8));
      CHECK(derivative_at(curve, t).y == doctest::Approx(difference.y).epsilon(1e-8));
    }
  }
}

TEST_CASE("halfway on a straight curve is the chord's midpoint") {
  const CurvePoint m = halfway(StraightCurve{}, {{1, 1}, {4, 5}, 0.5, 0.75});
  CHECK(m.point == Point{2.5, 3});
  CHECK(m.t == 0.625);
}

TEST_CASE("halfway lies on the curve and equally far from both ends") {
  const Curve arc = circle({0, 0}, 2, 0.3, 2);
  const Curve ellipse = EllipseArc{{1, 1}, {4, 0}, {0, 1}, 0.1, 1.2};
  for (const Curve& curve : {arc, ellipse, cubic_parabola()}) {
    for (const auto& row : {std::pair{0.0, 0.3}, {0.3, 0.45}, {0.9, 0.6}, {0.5, 0.5001}}) {
      const auto& from = row.first;
      const auto& to = row.second;
      CAPTURE(from);
      const CurvePiece piece = piece_of(curve, from, to);
      const CurvePoint m = halfway(curve, piece);
      CHECK(m.point == point_at(curve, m.t));
      CHECK(m.t > std::min(from, to));
      CHECK(m.t < std::max(from, to));
      const double a = distance(piece.a, m.point), b = distance(piece.b, m.point);
      CHECK(std::abs(a - b) <= 4e-15);
      CHECK(a > 0.49 * distance(piece.a, piece.b));
    }
  }
}

TEST_CASE("halfway of a circular arc is at half its angle") {
  const Curve arc = circle({0, 0}, 1, 0, 2 * std::numbers::pi);
  CHECK(halfway(arc, piece_of(arc, 0.25, 0.75)).t == doctest::Approx(0.5).epsilon(1e-14));
  CHECK(halfway(arc, piece_of(arc, 0.875, 1)).t == doctest::Approx(0.9375).epsilon(1e-14));
}

TEST_CASE("at_distance is at that distance, from whichever end is named first") {
  const Curve arc = circle({0, 0}, 2, 0.3, 2);
  for (const Curve& curve : {arc, cubic_parabola(), Curve(StraightCurve{})}) {
    CurvePiece piece{{0, 0}, {3, 4}, 0, 1};
    if (!is_straight(curve)) piece = piece_of(curve, 0.2, 0.5);
    for (const double share : {1e-6, 0.25, 0.5, 0.99}) {
      CAPTURE(share);
      const double radius = share * distance(piece.a, piece.b);
      const CurvePoint p = at_distance(curve, piece, radius);
      CHECK(distance(p.point, piece.a) == doctest::Approx(radius).epsilon(1e-9));
      const CurvePiece reversed{piece.b, piece.a, piece.t_b, piece.t_a};
      const CurvePoint q = at_distance(curve, reversed, radius);
      CHECK(distance(q.point, piece.b) == doctest::Approx(radius).epsilon(1e-9));
    }
  }
}
