#include "lepp/io/sample_values.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "lepp/geometry/error.hpp"

namespace lepp {

namespace {

template <class T, bool swapped>
T value_at(const std::byte* place) {
  std::array<std::byte, sizeof(T)> bytes;
  std::memcpy(bytes.data(), place, sizeof(T));
  if constexpr (swapped) std::ranges::reverse(bytes);
  return std::bit_cast<T>(bytes);
}

template <class Height>
Height height_of(std::integral auto value) {
  if constexpr (sizeof(value) == 8) return height_of_integer(value);
  else return static_cast<Height>(value);
}
template <class Height>
Height height_of(std::floating_point auto value) {
  return value;
}

template <class T, bool swapped, class Height>
void convert(const NodataRange& nodata, std::span<const std::byte> samples,
             std::span<Height> heights) {
  const std::byte* place = samples.data();
  for (Height& height : heights) {
    const T value = value_at<T, swapped>(place);
    place += sizeof(T);
    height =
        nodata.has(value) ? std::numeric_limits<Height>::quiet_NaN() : height_of<Height>(value);
  }
}

template <class T, class Height>
void convert(const RasterLayout& layout, const NodataRange& nodata,
             std::span<const std::byte> samples, std::span<Height> heights) {
  const bool swapped = layout.big_endian != (std::endian::native == std::endian::big);
  if (swapped) convert<T, true>(nodata, samples, heights);
  else convert<T, false>(nodata, samples, heights);
}

// The nearest float, or an infinity.
float to_float(double value) {
  constexpr double limit = 0x1.ffffffp127;  // from here on the nearest float would be 2^128
  if (value >= limit) return std::numeric_limits<float>::infinity();
  if (value <= -limit) return -std::numeric_limits<float>::infinity();
  return static_cast<float>(value);
}

template <class Height>
std::optional<std::size_t> first_beyond(std::span<const Height> heights, Height limit) {
  bool any = false;
  for (const Height h : heights) any |= std::abs(h) > limit;
  if (!any) return std::nullopt;
  const auto found = std::ranges::find_if(heights, [&](Height h) { return std::abs(h) > limit; });
  return static_cast<std::size_t>(found - heights.begin());
}

}  // namespace

NodataRange::NodataRange(std::optional<double> nodata) {
  if (!nodata || std::isnan(*nodata)) return;
  const double value = *nodata;
  const bool is_no_height = std::abs(value) > 1e30 && std::isfinite(value);
  const double around = is_no_height ? 1e-6 * std::abs(value) : 0;
  low_wide = value - around;
  high_wide = value + around;
  low = to_float(low_wide);
  high = to_float(high_wide);
}

void convert_samples(const RasterLayout& layout, const NodataRange& nodata,
                     std::span<const std::byte> samples, std::span<float> heights) {
  switch (layout.type) {
    case SampleType::u8:
      return convert<std::uint8_t>(layout, nodata, samples, heights);
    case SampleType::i8:
      return convert<std::int8_t>(layout, nodata, samples, heights);
    case SampleType::u16:
      return convert<std::uint16_t>(layout, nodata, samples, heights);
    case SampleType::i16:
      return convert<std::int16_t>(layout, nodata, samples, heights);
    default:
      return convert<float>(layout, nodata, samples, heights);
  }
}

void convert_samples(const RasterLayout& layout, const NodataRange& nodata,
                     std::span<const std::byte> samples, std::span<double> heights) {
  switch (layout.type) {
    case SampleType::u32:
      return convert<std::uint32_t>(layout, nodata, samples, heights);
    case SampleType::i32:
      return convert<std::int32_t>(layout, nodata, samples, heights);
    case SampleType::u64:
      return convert<std::uint64_t>(layout, nodata, samples, heights);
    case SampleType::i64:
      return convert<std::int64_t>(layout, nodata, samples, heights);
    default:
      return convert<double>(layout, nodata, samples, heights);
  }
}

std::optional<std::size_t> first_unusable(std::span<const float> heights) {
  return first_beyond(heights, std::numeric_limits<float>::max());
}

std::optional<std::size_t> first_unusable(std::span<const double> heights) {
  return first_beyond(heights, largest_height);
}

void refuse_height(const std::string& source, std::uint64_t column, std::uint64_t row) {
  throw InputError(source + ", column " + std::to_string(column) + ", row " + std::to_string(row),
                   unusable_height, unusable_height_remedy);
}

}  // namespace lepp
