#pragma once

#include <cmath>

#include "lepp/geometry/point.hpp"

namespace lepp {

namespace exact {
// The same signs after the cheap filter: for incircle by a closer one; else in integers where the
// points share a grid of 61 bits (integer_signs.hpp); else in expansions (expansion.hpp).
int orient2d(Point a, Point b, Point c);
int incircle(Point a, Point b, Point c, Point d);
int dot_sign(Point a, Point apex, Point b);
}  // namespace exact

namespace filter {
// Half an ulp of 1: the largest relative error of one rounded operation.
inline constexpr double epsilon = 0x1p-53;
// First-order coefficients of the errors of the rounded determinants, with room for second order.
// They hold with and without fused operations. Two products of differences: relative to their
// sizes, as in [shewchuk1997]. In-circle: relative to mx my m^2, where mx and my bound the
// differences in x and y, and m both. A factor such as bx dy - by dx is at most 2 mx my, or 2 m^2,
// with an error of 8 units of that half; the product of two factors then has 36, and the difference
// of two products 80.
inline constexpr double two_products = (3 + 16 * epsilon) * epsilon;
inline constexpr double incircle = 81 * epsilon;

inline double larger(double a, double b) { return a < b ? b : a; }
inline double largest(double a, double b, double c, double d, double e) {
  return larger(larger(larger(std::abs(a), std::abs(b)), larger(std::abs(c), std::abs(d))),
                std::abs(e));
}
inline int sign_of(double x) { return (x > 0) - (x < 0); }
}  // namespace filter

/// Exact signs. Each is -1, 0 or +1, decided by a cheap floating-point filter. Where that cannot
/// tell, incircle asks a closer one; then come integers, then expansions.
/// \pre    coordinates in the supported range of pslg.hpp
/// Source  [shewchuk1997] for expansions and the shape of the error bounds

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
  // (ab x ad) (ac . bc) - (ab x ac) (ad . bd), which needs ten products [devillers2003].
  const double bx = b.x - a.x, by = b.y - a.y;
  const double cx = c.x - a.x, cy = c.y - a.y;
  const double dx = d.x - a.x, dy = d.y - a.y;
  const double det = (bx * dy - by * dx) * (cx * (c.x - b.x) + cy * (c.y - b.y)) -
                     (bx * cy - by * cx) * (dx * (d.x - b.x) + dy * (d.y - b.y));
  const double mx = filter::largest(bx, cx, dx, c.x - b.x, d.x - b.x);
  const double my = filter::largest(by, cy, dy, c.y - b.y, d.y - b.y);
  const double m = mx < my ? my : mx;
  if (std::abs(det) > filter::incircle * (mx * my) * (m * m)) return filter::sign_of(det);
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
