#include "lepp/geometry/curve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lepp {
namespace {

Point lerp(Point a, Point b, double s) { return (1 - s) * a + s * b; }

Point point_of(const EllipseArc& arc, double t) {
  const double angle = arc.start + t * arc.sweep;
  return arc.center + std::cos(angle) * arc.u + std::sin(angle) * arc.v;
}

Point derivative_of(const EllipseArc& arc, double t) {
  const double angle = arc.start + t * arc.sweep;
  return arc.sweep * (std::cos(angle) * arc.v - std::sin(angle) * arc.u);
}

/// The piece that covers t, and where t lies in it, from 0 to 1.
std::pair<std::size_t, double> locate(const CubicPieces& cubics, double t) {
  const auto& knots = cubics.knots;
  const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, t);
  const auto i = static_cast<std::size_t>(above - knots.begin()) - 1;
  return {i, (t - knots[i]) / (knots[i + 1] - knots[i])};
}

/// de Casteljau's scheme.
Point point_of(const CubicPieces& cubics, double t) {
  const auto [i, s] = locate(cubics, t);
  const auto& [a, b, c, d] = cubics.pieces[i];
  const Point ab = lerp(a, b, s), bc = lerp(b, c, s), cd = lerp(c, d, s);
  return lerp(lerp(ab, bc, s), lerp(bc, cd, s), s);
}

Point derivative_of(const CubicPieces& cubics, double t) {
  const auto [i, s] = locate(cubics, t);
  const auto& [a, b, c, d] = cubics.pieces[i];
  const double width = cubics.knots[i + 1] - cubics.knots[i];
  return 3 / width * lerp(lerp(b - a, c - b, s), lerp(c - b, d - c, s), s);
}

Point point_of(const StraightCurve&, double) { return {}; }
Point derivative_of(const StraightCurve&, double) { return {}; }

double distance(Point a, Point b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// A zero of `f` between t_low and t_high, where f is negative at the first and positive at the
/// second: false position with the Illinois weights, bisection whenever that is slow.
template <class Function>
double zero_between(double t_low, double t_high, double f_low, double f_high, const Function& f) {
  for (int step = 0; step < 200; ++step) {  // ends: every third step halves the bracket
    double t = t_low - f_low * (t_high - t_low) / (f_high - f_low);
    const double low = std::min(t_low, t_high), high = std::max(t_low, t_high);
    if (step % 3 == 2 || !(t > low && t < high)) t = 0.5 * (t_low + t_high);
    if (!(t > low && t < high)) break;  // no double left between the two
    const double value = f(t);
    if (value == 0) return t;
    if (value < 0) {
      t_low = t;
      f_low = value;
      f_high *= 0.5;
    } else {
      t_high = t;
      f_high = value;
      f_low *= 0.5;
    }
  }
  return std::abs(f(t_low)) <= std::abs(f(t_high)) ? t_low : t_high;
}

}  // namespace

Point point_at(const Curve& curve, double t) {
  return std::visit([t](const auto& shape) { return point_of(shape, t); }, curve);
}

Point derivative_at(const Curve& curve, double t) {
  return std::visit([t](const auto& shape) { return derivative_of(shape, t); }, curve);
}

CurvePoint halfway(const Curve& curve, const CurvePiece& piece) {
  if (is_straight(curve)) return {midpoint(piece.a, piece.b), 0.5 * (piece.t_a + piece.t_b)};
  const double length = distance(piece.a, piece.b);
  const double t = zero_between(piece.t_a, piece.t_b, -length, length, [&](double s) {
    const Point p = point_at(curve, s);
    return distance(piece.a, p) - distance(piece.b, p);
  });
  return {point_at(curve, t), t};
}

CurvePoint at_distance(const Curve& curve, const CurvePiece& piece, double radius) {
  const double length = distance(piece.a, piece.b);
  if (is_straight(curve)) {
    const double s = radius / length;
    return {lerp(piece.a, piece.b, s), piece.t_a + s * (piece.t_b - piece.t_a)};
  }
  const double t = zero_between(piece.t_a, piece.t_b, -radius, length - radius, [&](double s) {
    return distance(piece.a, point_at(curve, s)) - radius;
  });
  return {point_at(curve, t), t};
}

}  // namespace lepp
