#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <variant>
#include <vector>

namespace lepp {

/// Larger heights are refused, as larger coordinates are: products of a few of them stay finite.
inline constexpr double largest_height = 0x1p200;

/// The heights there are: the lowest and the highest, and how many; low > high if there are none.
struct HeightRange {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  std::size_t count = 0;
};

/// Heights of samples, NaN where there is no data, each exactly as it was given: floats as long as
/// every one is a float, doubles from the first one on that is not. Which of the two they are
/// follows from what was put in.
class Heights {
 public:
  using Floats = std::vector<float>;
  using Doubles = std::vector<double>;

  std::size_t size() const {
    return std::visit([](const auto& values) { return values.size(); }, values_);
  }
  bool empty() const { return size() == 0; }
  /// 4 bytes for each height, or else 8.
  bool are_floats() const { return std::holds_alternative<Floats>(values_); }
  /// Of memory, with what is reserved.
  std::size_t bytes() const;

  double operator[](std::size_t i) const {
    const auto* const floats = std::get_if<Floats>(&values_);
    return floats != nullptr ? double((*floats)[i]) : (*std::get_if<Doubles>(&values_))[i];
  }
  double back() const { return (*this)[size() - 1]; }

  HeightRange range() const;  ///< O(size())

  void reserve(std::size_t count);
  /// New heights are without data.
  void resize(std::size_t count);
  // The first height that is no float costs O(size()), and for that time half as much memory again.
  void set(std::size_t i, double height);
  void push_back(double height);
  void append(std::span<const float> heights);
  void append(std::span<const double> heights);
  /// Replaces those from index `first` on.
  void assign(std::size_t first, std::span<const float> heights);
  void assign(std::size_t first, std::span<const double> heights);

  /// For loops over many: visit(std::span<const float>) or visit(std::span<const double>).
  template <class Visit>
  decltype(auto) visit(Visit visit) const {
    if (const auto* const floats = std::get_if<Floats>(&values_))
      return visit(std::span<const float>(*floats));
    return visit(std::span<const double>(*std::get_if<Doubles>(&values_)));
  }

  friend bool operator==(const Heights&, const Heights&) = default;  // a NaN is not itself

 private:
  void widen();
  void widen_for(std::span<const double> heights);
  template <class Height>
  void append_any(std::span<const Height> heights);
  template <class Height>
  void assign_any(std::size_t first, std::span<const Height> heights);

  std::variant<Floats, Doubles> values_;
};

/// True if a float holds `height`, or if it is NaN.
inline bool is_float(double height) {
  constexpr double most = std::numeric_limits<float>::max();
  return std::isnan(height) ||
         (std::abs(height) <= most && double(static_cast<float>(height)) == height);
}

}  // namespace lepp
