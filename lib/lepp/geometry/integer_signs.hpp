#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "lepp/geometry/point.hpp"

namespace lepp {

/// Points as integers: multiples of the lowest bit that any of their coordinates has. Nearly all
/// points of one neighbourhood share such a grid of 61 bits, and there a determinant is a handful
/// of integer products, exact whether it vanishes or not.
template <std::size_t N>
struct GridPoints {
  std::array<std::int64_t, N> x, y;  ///< below 2^61 in absolute value
};

namespace integer {

/// A finite double as sign * mantissa * 2^exponent with an odd mantissa; zero has mantissa 0.
struct Parts {
  std::uint64_t mantissa;
  int exponent;
  bool negative;
};

inline Parts parts_of(double c) {
  const auto bits = std::bit_cast<std::uint64_t>(c);
  const std::uint64_t fraction = bits & 0xFFFFFFFFFFFFFU;
  const int biased = static_cast<int>(bits >> 52 & 0x7FFU);
  if (biased == 0) return {0, 0, false};  // zero: the supported range holds no denormal number
  const std::uint64_t mantissa = fraction | std::uint64_t{1} << 52;
  const int zeros = std::countr_zero(mantissa);
  return {mantissa >> zeros, biased - 1075 + zeros, bits >> 63 != 0};
}

}  // namespace integer

/// The points on their common grid, or nothing if it would take more than 61 bits.
/// \pre coordinates in the supported range of pslg.hpp
template <std::size_t N>
std::optional<GridPoints<N>> on_common_grid(const std::array<Point, N>& points) {
  std::array<integer::Parts, 2 * N> parts;
  int lowest = 4096, highest = -4096;
  for (std::size_t i = 0; i < 2 * N; ++i) {
    parts[i] = integer::parts_of(i < N ? points[i].x : points[i - N].y);
    if (parts[i].mantissa == 0) continue;
    const int width = static_cast<int>(std::bit_width(parts[i].mantissa));
    lowest = parts[i].exponent < lowest ? parts[i].exponent : lowest;
    highest = parts[i].exponent + width > highest ? parts[i].exponent + width : highest;
  }
  if (highest - lowest > 61) return std::nullopt;
  GridPoints<N> grid;
  for (std::size_t i = 0; i < 2 * N; ++i) {
    const integer::Parts& p = parts[i];
    const auto size =
        p.mantissa == 0 ? 0 : static_cast<std::int64_t>(p.mantissa << (p.exponent - lowest));
    (i < N ? grid.x[i] : grid.y[i - N]) = p.negative ? -size : size;
  }
  return grid;
}

namespace integer {

__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;

inline int sign_of(Int128 v) { return (v > 0) - (v < 0); }

/// A sum of products of 128-bit numbers, modulo 2^256 in two's complement.
class Sum256 {
 public:
  /// Adds a * b. \pre a >= 0
  void add_product(UInt128 a, Int128 b) {
    const bool negative = b < 0;
    const UInt128 c = negative ? -static_cast<UInt128>(b) : static_cast<UInt128>(b);
    const auto a0 = static_cast<std::uint64_t>(a), a1 = static_cast<std::uint64_t>(a >> 64);
    const auto c0 = static_cast<std::uint64_t>(c), c1 = static_cast<std::uint64_t>(c >> 64);
    const UInt128 low = UInt128{a0} * c0, one = UInt128{a0} * c1;
    const UInt128 two = UInt128{a1} * c0, high = UInt128{a1} * c1;
    const UInt128 middle = (low >> 64) + static_cast<std::uint64_t>(one) +
                           static_cast<std::uint64_t>(two);
    const UInt128 top = high + (one >> 64) + (two >> 64) + (middle >> 64);
    add(top, middle << 64 | static_cast<std::uint64_t>(low), negative);
  }

  int sign() const {
    if (static_cast<Int128>(high_) < 0) return -1;
    return high_ != 0 || low_ != 0;
  }

 private:
  void add(UInt128 high, UInt128 low, bool negative) {
    if (negative) {
      high_ -= high + (low_ < low ? 1 : 0);
      low_ -= low;
    } else {
      low_ += low;
      high_ += high + (low_ < low ? 1 : 0);
    }
  }

  UInt128 high_ = 0, low_ = 0;
};

/// Signs of the determinants of predicates.hpp. Differences are below 2^62, products of two below
/// 2^124, sums of two of them below 2^125, and the products of those below 2^250.
inline int orient2d(const GridPoints<3>& p) {
  const Int128 left = Int128{p.x[0] - p.x[2]} * (p.y[1] - p.y[2]);
  const Int128 right = Int128{p.y[0] - p.y[2]} * (p.x[1] - p.x[2]);
  return sign_of(left - right);
}

/// Points a, apex, b.
inline int dot_sign(const GridPoints<3>& p) {
  const Int128 x = Int128{p.x[0] - p.x[1]} * (p.x[2] - p.x[1]);
  const Int128 y = Int128{p.y[0] - p.y[1]} * (p.y[2] - p.y[1]);
  return sign_of(x + y);
}

inline int incircle(const GridPoints<4>& p) {
  const auto dx = [&](std::size_t i) { return Int128{p.x[i] - p.x[3]}; };
  const auto dy = [&](std::size_t i) { return Int128{p.y[i] - p.y[3]}; };
  Sum256 det;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = i == 2 ? 0 : i + 1, k = i == 0 ? 2 : i - 1;
    const Int128 cross = dx(j) * dy(k) - dy(j) * dx(k);
    det.add_product(static_cast<UInt128>(dx(i) * dx(i) + dy(i) * dy(i)), cross);
  }
  return det.sign();
}

}  // namespace integer

}  // namespace lepp
