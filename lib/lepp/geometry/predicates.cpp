#include "lepp/geometry/predicates.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "lepp/geometry/expansion.hpp"
#include "lepp/geometry/integer_signs.hpp"

namespace lepp {

// Coordinates are 0 or in [2^-140, 2^200] (pslg.hpp), so they are multiples of 2^-192 and every
// product of up to four differences is a multiple of 2^-768 below 2^810: nothing under- or
// overflows, and each expansion below is exact.
static_assert(std::numeric_limits<double>::is_iec559);

namespace {

// The rounded determinant with the error bound of [shewchuk1997], which follows the size of its
// terms more closely than the bound that is cheap to have.
std::optional<int> filtered_incircle(Point a, Point b, Point c, Point d) {
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
  constexpr double bound = (10 + 96 * filter::epsilon) * filter::epsilon;
  if (std::abs(det) > bound * size) return filter::sign_of(det);
  return std::nullopt;
}

}  // namespace

namespace exact {

int orient2d(Point a, Point b, Point c) {
  if (const auto grid = on_common_grid<3>({a, b, c})) return integer::orient2d(*grid);
  const auto left = difference(a.x, c.x) * difference(b.y, c.y);
  const auto right = difference(a.y, c.y) * difference(b.x, c.x);
  return (left - right).sign();
}

int dot_sign(Point a, Point apex, Point b) {
  if (const auto grid = on_common_grid<3>({a, apex, b})) return integer::dot_sign(*grid);
  const auto x = difference(a.x, apex.x) * difference(b.x, apex.x);
  const auto y = difference(a.y, apex.y) * difference(b.y, apex.y);
  return (x + y).sign();
}

int incircle(Point a, Point b, Point c, Point d) {
  if (const auto sign = filtered_incircle(a, b, c, d)) return *sign;
  if (const auto grid = on_common_grid<4>({a, b, c, d})) return integer::incircle(*grid);
  const auto ax = difference(a.x, d.x), ay = difference(a.y, d.y);
  const auto bx = difference(b.x, d.x), by = difference(b.y, d.y);
  const auto cx = difference(c.x, d.x), cy = difference(c.y, d.y);
  const auto term = [](const auto& x, const auto& y, const auto& cross) {
    return (x * x + y * y) * cross;
  };
  const auto from_a = term(ax, ay, bx * cy - by * cx);
  const auto from_b = term(bx, by, cx * ay - cy * ax);
  const auto from_c = term(cx, cy, ax * by - ay * bx);
  return (from_a + from_b + from_c).sign();
}

}  // namespace exact

bool predicates_self_test() {
  // Three points on a line far from the origin, and one a single ulp off it, either way.
  const Point far_a{12, 12}, far_b{24, 24};
  const Point off{0.5, std::nextafter(0.5, 1)}, under{0.5, std::nextafter(0.5, 0)};
  // A circle of radius 65 about a point with large coordinates: (16, 63), (33, 56), ... lie on it.
  const Point center{1e7, -3e6};
  const Point p = center + Point{16, 63}, q = center + Point{-33, 56}, r = center + Point{-63, -16};
  const Point on = center + Point{56, -33};
  const Point in{on.x, std::nextafter(on.y, 0)}, out{on.x, std::nextafter(on.y, -1e9)};
  // A right angle with inexact legs.
  const Point apex{0.1, 0.1}, u{0.1 + 0x1p-30, 0.1}, v{0.1, 0.1 + 0x1p-40};
  // Coordinates of scales so far apart that only expansions can tell.
  constexpr double e = 0x1p-80;
  const Point one{1, 1}, three{3, 3};
  const bool expansions =
      orient2d({e, e / 2}, one, three) == -1 && orient2d({e / 2, e}, one, three) == 1 &&
      orient2d({e, e}, one, three) == 0 && incircle({1, 0}, {0, 1}, {-1, 0}, {0x1p-70, -1}) == -1;
  return expansions && orient2d({0.5, 0.5}, far_a, far_b) == 0 &&
         orient2d(far_a, far_b, off) == 1 && orient2d(far_a, far_b, under) == -1 &&
         incircle(p, q, r, on) == 0 && incircle(p, q, r, in) == 1 && incircle(p, q, r, out) == -1 &&
         dot_sign(u, apex, v) == 0 && dot_sign({u.x, std::nextafter(u.y, 0)}, apex, v) == -1 &&
         dot_sign({u.x, std::nextafter(u.y, 1)}, apex, v) == 1;
}

}  // namespace lepp
