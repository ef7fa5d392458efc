#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "lepp/io/raster_layout.hpp"

namespace lepp {

/// The nearest float, or an infinity.
inline float to_float(double value) {
  constexpr double limit = 0x1.ffffffp127;  // from here on the nearest float would be 2^128
  if (value >= limit) return std::numeric_limits<float>::infinity();
  if (value <= -limit) return -std::numeric_limits<float>::infinity();
  return static_cast<float>(value);
}

/// Which heights mean that there is none: one value, as it is and as the nearest float; of values
/// beyond 1e30, which are no heights, also what a text with seven digits made of it.
struct NodataRange {
  float low = 1, high = -1;  // empty
  double exact = std::numeric_limits<double>::quiet_NaN();

  explicit NodataRange(std::optional<double> nodata);
  /// For heights that floats hold.
  bool has(float height) const { return low <= height && height <= high; }
};

/// Turns samples into floats, NaN where there is no data.
/// \return  the largest |sample - height|
double convert_samples(const RasterLayout& layout, const NodataRange& nodata,
                       std::span<const std::byte> samples, std::span<float> heights);

/// The index of the first height that is infinite, if there is one.
std::optional<std::size_t> first_infinite(std::span<const float> heights);

/// \throw InputError  about an infinite height at this place of the file
[[noreturn]] void refuse_infinite(const std::string& source, std::uint64_t column,
                                  std::uint64_t row);

}  // namespace lepp
