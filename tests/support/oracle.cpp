#include "support/oracle.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

namespace lepp::test {

namespace {

namespace mp = boost::multiprecision;
__extension__ typedef __int128 Wide;

template <class Number>
int sign_of(const Number& x) {
  return (x > 0) - (x < 0);
}

// A double is mantissa * 2^exponent, with an odd mantissa, or 0.
struct Parts {
  std::int64_t mantissa = 0;
  int exponent = 0;
};

Parts parts_of(double x) {
  if (x == 0) return {};
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto biased = static_cast<int>(bits >> 52 & 0x7FFU);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  auto mantissa =
      static_cast<std::int64_t>(biased == 0 ? fraction : fraction | std::uint64_t{1} << 52);
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
  mantissa >>= zeros;
  return {(bits >> 63) != 0 ? -mantissa : mantissa, (biased == 0 ? 1 : biased) - 1075 + zeros};
}

// All coordinates of N points as integers times one power of two.
template <std::size_t N>
class Scaled {
 public:
  explicit Scaled(const std::array<Point, N>& points) {
    int high = 0;
    bool first = true;
    for (std::size_t i = 0; i < N; ++i) {
      parts_[2 * i] = parts_of(points[i].x);
      parts_[2 * i + 1] = parts_of(points[i].y);
    }
    for (const Parts& p : parts_) {
      if (p.mantissa == 0) continue;
      const auto size = static_cast<std::uint64_t>(std::abs(p.mantissa));
      const int top = p.exponent + static_cast<int>(std::bit_width(size));
      low_ = first ? p.exponent : std::min(low_, p.exponent);
      high = first ? top : std::max(high, top);
      first = false;
    }
    bits_ = high - low_;
  }

  /// Every integer is below 2^bits in absolute value.
  int bits() const { return bits_; }

  template <class Integer>
  std::array<Integer, 2 * N> integers() const {
    std::array<Integer, 2 * N> result{};
    for (std::size_t i = 0; i < 2 * N; ++i) {
      if (parts_[i].mantissa == 0) continue;
      Integer value = std::abs(parts_[i].mantissa);
      value <<= parts_[i].exponent - low_;
      result[i] = parts_[i].mantissa < 0 ? Integer(-value) : value;
    }
    return result;
  }

 private:
  std::array<Parts, 2 * N> parts_;
  int low_ = 0;
  int bits_ = 0;
};

template <class Integer>
int orient2d_sign(const std::array<Integer, 6>& p) {
  const Integer left = (p[0] - p[4]) * (p[3] - p[5]);
  const Integer right = (p[1] - p[5]) * (p[2] - p[4]);
  return sign_of(Integer(left - right));
}

template <class Integer>
int dot_sign_of(const std::array<Integer, 6>& p) {
  const Integer x = (p[0] - p[2]) * (p[4] - p[2]);
  const Integer y = (p[1] - p[3]) * (p[5] - p[3]);
  return sign_of(Integer(x + y));
}

// Half holds products of two differences, Full of four.
template <class Half, class Full>
int incircle_sign(const std::array<Half, 8>& p) {
  const Half ax = p[0] - p[6], ay = p[1] - p[7];
  const Half bx = p[2] - p[6], by = p[3] - p[7];
  const Half cx = p[4] - p[6], cy = p[5] - p[7];
  const Half a2 = ax * ax + ay * ay, bc = bx * cy - by * cx;
  const Half b2 = bx * bx + by * by, ca = cx * ay - cy * ax;
  const Half c2 = cx * cx + cy * cy, ab = ax * by - ay * bx;
  const Full det = Full(a2) * Full(bc) + Full(b2) * Full(ca) + Full(c2) * Full(ab);
  return sign_of(det);
}

// The largest sizes, in bits, for which the products fit: two differences in 128 bits, four in 128,
// in 256 and in 1024.
constexpr int two_fit_128 = 61, four_fit_128 = 29, four_fit_256 = 61, four_fit_1024 = 253;

template <std::size_t N>
std::array<mp::cpp_rational, 2 * N> rationals(const std::array<Point, N>& points) {
  std::array<mp::cpp_rational, 2 * N> result;
  for (std::size_t i = 0; i < N; ++i) {
    result[2 * i] = mp::cpp_rational(points[i].x);
    result[2 * i + 1] = mp::cpp_rational(points[i].y);
  }
  return result;
}

}  // namespace

int exact_orient2d(Point a, Point b, Point c) {
  const Scaled<3> scaled({a, b, c});
  if (scaled.bits() <= two_fit_128) return orient2d_sign(scaled.integers<Wide>());
  return orient2d_sign(scaled.integers<mp::cpp_int>());
}

int exact_dot_sign(Point a, Point apex, Point b) {
  const Scaled<3> scaled({a, apex, b});
  if (scaled.bits() <= two_fit_128) return dot_sign_of(scaled.integers<Wide>());
  return dot_sign_of(scaled.integers<mp::cpp_int>());
}

int exact_incircle(Point a, Point b, Point c, Point d) {
  const Scaled<4> scaled({a, b, c, d});
  if (scaled.bits() <= four_fit_128) return incircle_sign<Wide, Wide>(scaled.integers<Wide>());
  if (scaled.bits() <= four_fit_256) {
    return incircle_sign<Wide, mp::int256_t>(scaled.integers<Wide>());
  }
  if (scaled.bits() <= four_fit_1024) {
    return incircle_sign<mp::int1024_t, mp::int1024_t>(scaled.integers<mp::int1024_t>());
  }
  return incircle_sign<mp::cpp_int, mp::cpp_int>(scaled.integers<mp::cpp_int>());
}

int rational_orient2d(Point a, Point b, Point c) { return orient2d_sign(rationals<3>({a, b, c})); }

int rational_dot_sign(Point a, Point apex, Point b) {
  return dot_sign_of(rationals<3>({a, apex, b}));
}

int rational_incircle(Point a, Point b, Point c, Point d) {
  return incircle_sign<mp::cpp_rational, mp::cpp_rational>(rationals<4>({a, b, c, d}));
}

// Relative errors: a difference has one rounding, 2^-53. A product of two differences has three,
// their sum one more: 4 * 2^-53 to first order, of the sum of absolute values. A product of four
// differences and its sums has at most ten. Twice as much, and more, leaves room for second order
// and for the rounding of the bound; in the supported range nothing underflows.
int oracle_orient2d(Point a, Point b, Point c) {
  const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  if (std::abs(det) > 0x1p-50 * (std::abs(left) + std::abs(right))) return sign_of(det);
  return exact_orient2d(a, b, c);
}

int oracle_dot_sign(Point a, Point apex, Point b) {
  const double x = (a.x - apex.x) * (b.x - apex.x), y = (a.y - apex.y) * (b.y - apex.y);
  const double sum = x + y;
  if (std::abs(sum) > 0x1p-50 * (std::abs(x) + std::abs(y))) return sign_of(sum);
  return exact_dot_sign(a, apex, b);
}

int oracle_incircle(Point a, Point b, Point c, Point d) {
  const Point p = a - d, q = b - d, r = c - d;
  const double p2 = dot(p, p), q2 = dot(q, q), r2 = dot(r, r);
  const double det = p2 * cross(q, r) + q2 * cross(r, p) + r2 * cross(p, q);
  const auto size = [](Point u, Point w) { return std::abs(u.x * w.y) + std::abs(u.y * w.x); };
  const double bound = 0x1p-48 * (p2 * size(q, r) + q2 * size(r, p) + r2 * size(p, q));
  if (std::abs(det) > bound) return sign_of(det);
  return exact_incircle(a, b, c, d);
}

}  // namespace lepp::test
