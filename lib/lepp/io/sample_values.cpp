#include "lepp/io/sample_values.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <type_traits>

#include "lepp/geometry/error.hpp"

namespace lepp {

namespace {

constexpr float no_data = std::numeric_limits<float>::quiet_NaN();

template <class T, bool swapped>
T value_at(const std::byte* place) {
  std::array<std::byte, sizeof(T)> bytes;
  std::memcpy(bytes.data(), place, sizeof(T));
  if constexpr (swapped) std::ranges::reverse(bytes);
  return std::bit_cast<T>(bytes);
}

template <class T, bool swapped>
double convert(const NodataRange& nodata, std::span<const std::byte> samples,
               std::span<float> heights) {
  constexpr bool exact_as_float = sizeof(T) <= 2 || std::is_same_v<T, float>;
  double rounding = 0;
  const std::byte* place = samples.data();
  for (float& height : heights) {
    const T value = value_at<T, swapped>(place);
    place += sizeof(T);
    if constexpr (exact_as_float) {
      const float h = static_cast<float>(value);
      height = nodata.has(h) ? no_data : h;
    } else {
      const double wide = static_cast<double>(value);
      const float h = to_float(wide);
      const bool none = std::is_integral_v<T> ? wide == nodata.exact : nodata.has(h);
      height = none ? no_data : h;
      // False for NaN and for an infinite height.
      if (const double off = std::abs(wide - double(h)); !none && off > rounding && off < 1e300)
        rounding = off;
    }
  }
  return rounding;
}

template <class T>
double convert(const RasterLayout& layout, const NodataRange& nodata,
               std::span<const std::byte> samples, std::span<float> heights) {
  const bool swapped = layout.big_endian != (std::endian::native == std::endian::big);
  return swapped ? convert<T, true>(nodata, samples, heights)
                 : convert<T, false>(nodata, samples, heights);
}

}  // namespace

NodataRange::NodataRange(std::optional<double> nodata) {
  if (!nodata || std::isnan(*nodata)) return;
  exact = *nodata;
  low = high = to_float(exact);
  if (std::abs(exact) > 1e30) {
    low = to_float(exact - 1e-6 * std::abs(exact));
    high = to_float(exact + 1e-6 * std::abs(exact));
  }
}

double convert_samples(const RasterLayout& layout, const NodataRange& nodata,
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
    case SampleType::u32:
      return convert<std::uint32_t>(layout, nodata, samples, heights);
    case SampleType::i32:
      return convert<std::int32_t>(layout, nodata, samples, heights);
    case SampleType::f32:
      return convert<float>(layout, nodata, samples, heights);
    case SampleType::f64:
      return convert<double>(layout, nodata, samples, heights);
  }
  return 0;
}

std::optional<std::size_t> first_infinite(std::span<const float> heights) {
  bool any = false;
  for (const float h : heights) any |= std::abs(h) > std::numeric_limits<float>::max();
  if (!any) return std::nullopt;
  const auto found = std::ranges::find_if(heights, [](float h) { return std::isinf(h); });
  return static_cast<std::size_t>(found - heights.begin());
}

void refuse_infinite(const std::string& source, std::uint64_t column, std::uint64_t row) {
  throw InputError(source + ", column " + std::to_string(column) + ", row " + std::to_string(row),
                   "the height is infinite, or too large for a float",
                   "correct it, or name it as the value of no data");
}

}  // namespace lepp
