#pragma once

#include <bit>
#include <cstdint>

namespace lepp::test {

/// Random numbers that are the same with every compiler and standard library, which the
/// distributions of <random> are not. SplitMix64: one 64-bit state, every seed is good.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
  }
  /// 0 to n - 1; n > 0. The bias is below n / 2^64.
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(next() % n); }
  int between(int low, int high) {
    return low + static_cast<int>(below(static_cast<std::uint32_t>(high - low + 1)));
  }
  /// [0, 1), a multiple of 2^-53.
  double real() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double real(double low, double high) { return low + (high - low) * real(); }
  bool one_in(std::uint32_t n) { return below(n) == 0; }

 private:
  std::uint64_t state_;
};

/// `x` moved by `steps` representable numbers, up for positive steps; through zero if need be.
inline double move_by_ulps(double x, int steps) {
  // Doubles of one sign are ordered like their bit patterns.
  const auto bits = std::bit_cast<std::int64_t>(x);
  const std::int64_t place = bits < 0 ? -(bits & INT64_MAX) : bits;
  const std::int64_t moved = place + steps;
  return moved < 0 ? -std::bit_cast<double>(-moved) : std::bit_cast<double>(moved);
}

}  // namespace lepp::test
