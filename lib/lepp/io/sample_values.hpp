#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "lepp/io/raster_layout.hpp"

namespace lepp {

/// Which values mean that there is no height: one, compared in the type of the file (of floats the
/// one that is nearest to it); of values beyond 1e30, which are no heights, also what a text with
/// seven digits made of it.
struct NodataRange {
  float low = 1, high = -1;  // empty
  double low_wide = 1, high_wide = -1;

  explicit NodataRange(std::optional<double> nodata);
  bool has(float value) const { return low <= value && value <= high; }
  bool has(double value) const { return low_wide <= value && value <= high_wide; }
  bool has(std::integral auto value) const { return has(static_cast<double>(value)); }
};

/// Turns samples into heights, NaN where there is no data; infinite where a height has more than 53
/// bits. \pre gives_floats(layout.type)
void convert_samples(const RasterLayout& layout, const NodataRange& nodata,
                     std::span<const std::byte> samples, std::span<float> heights);
/// The same for the other types.
void convert_samples(const RasterLayout& layout, const NodataRange& nodata,
                     std::span<const std::byte> samples, std::span<double> heights);

/// A whole number as a height, infinite if doubles of its size are not all the whole numbers there.
double height_of_integer(std::integral auto value) {
  constexpr std::int64_t most = std::int64_t{1} << 53;
  const bool is_exact = std::cmp_less_equal(-most, value) && std::cmp_less_equal(value, most);
  return is_exact ? static_cast<double>(value) : std::numeric_limits<double>::infinity();
}

/// The index of the first height that is infinite or too large, if there is one.
std::optional<std::size_t> first_unusable(std::span<const float> heights);
std::optional<std::size_t> first_unusable(std::span<const double> heights);

inline constexpr const char* unusable_height =
    "the height is infinite, larger than 1.6e60, or a whole number of more than 53 bits";
inline constexpr const char* unusable_height_remedy =
    "correct it, or name it as the value of no data";

/// \throw InputError  about an unusable height at this place of the file
[[noreturn]] void refuse_height(const std::string& source, std::uint64_t column, std::uint64_t row);

}  // namespace lepp
