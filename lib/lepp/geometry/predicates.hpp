#pragma once

#include <cmath>

#include "lepp/geometry/point.hpp"

namespace lepp {

namespace exact {
// The same signs without a filter: in integers where the points share a grid of 61 bits
// (integer_signs.hpp), else by expansion arithmetic.
int orient2d(Point a, Point b, Point c);
int incircle(Point a, Point b, Point c, Point d);
int dot_sign(Point a, Point apex, Point b);
}  // namespace exact

namespace filter {
// Half an ulp of 1: the largest relative error of one rounded operation.
inline constexpr double epsilon = 0x1p-53;
// First-order coefficients of the error of the rounded determinants, with room for second order;
// as derived in [shewchuk1997]. They hold with and without fused operations.
inline constexpr double two_products = (3 + 16 * epsilon) * epsilon;
inline constexpr double incircle = (10 + 96 * epsilon) * epsilon;

inline int sign_of(double x) { return (x > 0) - (x < 0); }
}  // namespace filter

/// Exact signs. Each is -1, 0 or +1, decided by a floating-point filter and, where the filter
/// cannot tell, by expansion arithmetic. \pre coordinates in the supported range of pslg.hpp.
/// Source [shewchuk1997] for expansions and the shape of the error bounds.

/// +1 if a, b, c turn left (counter-clockwise), -1 if right, 0 if collinear.
inline int orient2d(Point a, Point b, Point c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  const double bound = filter::two_products * (std::abs(left) + std::abs(right));
  if (std::abs(det) > bound) return filter::sign_of(det);
  return exact::orient2d(a, b, c);
}

/// +1 if d lies strictly inside the circle through the counter-clockwise a, b, c; 0 on it.
inline int incircle(Point a, Point b, Point c, Point d) {
  const double ax = a.x - d.x, ay = a.y - d.y;
  const double bx = b.x - d.x, by = b.y - d.y;
  const double cx = c.x - d.x, cy = c.y - d.y;
  const double bc = bx * cy, cb = by * cx;
  const double ca = cx * ay, ac = cy * ax;
  const double ab = ax * by, ba = ay * bx;
  const double a2 = ax * ax + ay * ay;
  const double b2 = bx * bx + by * by;
  const double c2 = cx * cx + cy * cy;
  const double det = a2 * (bc - cb) + b2 * (ca - ac) + c2 * (ab - ba);
  const double size = a2 * (std::abs(bc) + std::abs(cb)) + b2 * (std::abs(ca) + std::abs(ac)) +
                      c2 * (std::abs(ab) + std::abs(ba));
  if (std::abs(det) > filter::incircle * size) return filter::sign_of(det);
  return exact::incircle(a, b, c, d);
}

/// Sign of (a - apex) . (b - apex): -1 if the angle at apex is obtuse, 0 if right, +1 if acute.
inline int dot_sign(Point a, Point apex, Point b) {
  const double x = (a.x - apex.x) * (b.x - apex.x);
  const double y = (a.y - apex.y) * (b.y - apex.y);
  const double sum = x + y;
  const double bound = filter::two_products * (std::abs(x) + std::abs(y));
  if (std::abs(sum) > bound) return filter::sign_of(sum);
  return exact::dot_sign(a, apex, b);
}

/// True if the angle a-apex-b is above 90 degrees, that is, apex lies strictly inside the
/// diametral circle of ab.
inline bool is_obtuse(Point a, Point apex, Point b) { return dot_sign(a, apex, b) < 0; }

/// True if the predicates still give the right sign on a handful of hard cases. False means this
/// build breaks floating-point arithmetic (-ffast-math, fused or extended operations).
/// Costs microseconds; the program asks it at start-up.
bool predicates_self_test();

}  // namespace lepp
