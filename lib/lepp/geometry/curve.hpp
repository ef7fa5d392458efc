#pragma once

#include <array>
#include <variant>
#include <vector>

#include "lepp/geometry/point.hpp"

namespace lepp {

/// A straight curve. It needs no data: a piece of it runs straight between its two end vertices.
struct StraightCurve {};

/// An arc of a circle or of an ellipse: center + cos(angle) u + sin(angle) v, with
/// angle = start + t sweep, t in [0, 1]. For a circle u and v are orthogonal and of equal length.
struct EllipseArc {
  Point center;
  Point u, v;
  double start = 0;  ///< radians
  double sweep = 0;  ///< radians, signed, |sweep| <= 2 pi
};

/// A chain of cubic Bezier pieces; piece i covers t in [knots[i], knots[i+1]].
struct CubicPieces {
  std::vector<double> knots;  ///< increasing, from 0 to 1, one more than pieces
  std::vector<std::array<Point, 4>> pieces;
};

using Curve = std::variant<StraightCurve, EllipseArc, CubicPieces>;

inline bool is_straight(const Curve& curve) { return std::holds_alternative<StraightCurve>(curve); }

/// The point of the curve at parameter t in [0, 1].
/// \pre  !is_straight(curve)
Point point_at(const Curve& curve, double t);

/// The derivative of point_at with respect to t: the direction in which the curve runs.
/// \pre  !is_straight(curve)
Point derivative_at(const Curve& curve, double t);

/// A piece of a curve: the two end points and their parameters. For a straight curve the
/// parameters run along the chord and are only bookkeeping.
struct CurvePiece {
  Point a, b;
  double t_a = 0, t_b = 1;
};

/// A new point that cuts a piece in two, with its parameter.
struct CurvePoint {
  Point point;
  double t = 0;
};

/// The point halfway between the ends of `piece`: the chord's midpoint on a straight curve, else
/// the point of the curve that is equally far from both ends, to rounding.
/// Cost  O(log(1 / rounding)) evaluations.
CurvePoint halfway(const Curve& curve, const CurvePiece& piece);

/// The point of `piece` at distance `radius` from its end `a`.
/// \pre  0 < radius < |b - a|
CurvePoint at_distance(const Curve& curve, const CurvePiece& piece, double radius);

}  // namespace lepp
