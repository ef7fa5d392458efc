#include "lepp/terrain/levels.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <type_traits>

namespace lepp {

double interpolation_rounding(const HeightGrid& grid) {
  constexpr double part = 0x1p-48, last_digit = 0x1p-53, of_denormals = 0x1p-1060;
  return grid.heights.visit([]<class Height>(std::span<const Height> heights) {
    Height low = std::numeric_limits<Height>::max(), high = -low;
    for (const Height h : heights) {
      low = h < low ? h : low;  // false for NaN
      high = h > high ? h : high;
    }
    if (low > high) return 0.0;  // no data
    const double largest = std::max(-double(low), double(high));
    const bool is_double = std::is_same_v<Height, double>;
    return is_double ? part * double(high - low) + last_digit * largest + of_denormals
                     : part * largest;
  });
}

Levels::Levels(const HeightGrid& grid, const SimplifyOptions& options, SimplifyReport& report)
    : grid_(grid), options_(options), report_(report), rounding_(interpolation_rounding(grid)) {}

double Levels::error() const {
  const auto& errors = options_.level_errors;
  return next_error_ < errors.size() ? raised(errors[next_error_]) : last_error();
}

std::size_t Levels::vertices() const {
  const auto& counts = options_.level_vertices;
  return next_count_ < counts.size() ? std::min(counts[next_count_], options_.max_vertices)
                                     : options_.max_vertices;
}

bool Levels::has_ended(const Tin& tin, double error) const {
  return error <= this->error() || tin.mesh.vertex_count() >= vertices();
}

bool Levels::next(const Tin& tin, double error) {
  if (cancelled_) return false;
  const std::size_t count = tin.mesh.vertex_count();
  const bool is_last = error <= last_error() || count >= options_.max_vertices;
  const std::size_t passed = pass(error, count, is_last);
  if (passed > 0) note(tin, passed);
  return passed > 0 && !is_last;
}

std::size_t Levels::pass(double error, std::size_t count, bool is_last) {
  const std::size_t errors = options_.level_errors.size(), counts = options_.level_vertices.size();
  const std::size_t before = next_error_ + next_count_;
  while (next_error_ < errors && error <= this->error()) ++next_error_;
  while (next_count_ < counts && (is_last || count >= vertices())) ++next_count_;
  const bool has_given_up = next_error_ + next_count_ == before && next_count_ < counts;
  if (has_given_up) ++next_count_;
  return next_error_ + next_count_ - before;
}

void Levels::note(const Tin& tin, std::size_t levels) {
  const TerrainLevel level{tin.mesh.vertex_count(), measure_error(grid_, tin).max};
  for (; levels > 0; --levels) {
    report_.levels.push_back(level);
    if (options_.on_level) options_.on_level(tin, level);
  }
}

}  // namespace lepp
