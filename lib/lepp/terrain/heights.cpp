#include "lepp/terrain/heights.hpp"

#include <algorithm>
#include <utility>

namespace lepp {

std::size_t Heights::bytes() const {
  return std::visit([](const auto& v) { return v.capacity() * sizeof(v[0]); }, values_);
}

HeightRange Heights::range() const {
  return visit([]<class Height>(std::span<const Height> values) {
    Height low = std::numeric_limits<Height>::infinity(), high = -low;
    std::size_t count = 0;
    for (const Height h : values) {
      low = h < low ? h : low;  // false for NaN
      high = h > high ? h : high;
      count += std::isnan(h) ? 0 : 1;
    }
    return HeightRange{low, high, count};
  });
}

void Heights::reserve(std::size_t count) {
  std::visit([&](auto& values) { values.reserve(count); }, values_);
}

void Heights::resize(std::size_t count) {
  std::visit([&](auto& values) { values.resize(count, std::numeric_limits<float>::quiet_NaN()); },
             values_);
}

void Heights::set(std::size_t i, double height) { assign(i, std::span(&height, 1)); }

void Heights::push_back(double height) {
  if (are_floats() && !is_float(height)) widen();
  std::visit([&]<class Height>(
                 std::vector<Height>& values) { values.push_back(static_cast<Height>(height)); },
             values_);
}

void Heights::append(std::span<const float> heights) { append_any(heights); }

void Heights::append(std::span<const double> heights) {
  widen_for(heights);
  append_any(heights);
}

void Heights::assign(std::size_t first, std::span<const float> heights) {
  assign_any(first, heights);
}

void Heights::assign(std::size_t first, std::span<const double> heights) {
  widen_for(heights);
  assign_any(first, heights);
}

template <class Height>
void Heights::append_any(std::span<const Height> heights) {
  std::visit([&](auto& values) { values.insert(values.end(), heights.begin(), heights.end()); },
             values_);
}

template <class Height>
void Heights::assign_any(std::size_t first, std::span<const Height> heights) {
  const auto place = static_cast<std::ptrdiff_t>(first);
  std::visit([&](auto& values) { std::ranges::copy(heights, values.begin() + place); }, values_);
}

void Heights::widen_for(std::span<const double> heights) {
  if (are_floats() && !std::ranges::all_of(heights, is_float)) widen();
}

void Heights::widen() {
  const Floats& floats = *std::get_if<Floats>(&values_);
  Doubles doubles;
  doubles.reserve(floats.capacity());
  doubles.assign(floats.begin(), floats.end());
  values_ = std::move(doubles);
}

}  // namespace lepp
