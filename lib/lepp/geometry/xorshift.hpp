#pragma once

#include <cstddef>
#include <cstdint>

namespace lepp {

/// A small generator of pseudo-random numbers, the same on every machine [marsaglia2003].
class XorShift {
 public:
  /// 0 to below - 1; below < 2^32
  std::uint32_t operator()(std::size_t below) {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 7;
    state_ ^= state_ << 17;
    return static_cast<std::uint32_t>((state_ >> 32) * below >> 32);
  }

 private:
  std::uint64_t state_ = 0x9E3779B97F4A7C15U;
};

}  // namespace lepp
