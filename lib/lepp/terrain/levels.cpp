#include "lepp/terrain/levels.hpp"

#include <algorithm>
#include <utility>

namespace lepp {

double interpolation_rounding(const HeightGrid& grid) {
  constexpr double part = 0x1p-48, last_digit = 0x1p-53, of_denormals = 0x1p-1060;
  const auto [low, high, count] = grid.heights.range();
  if (count == 0) return 0;
  const double largest = std::max(-low, high);
  if (grid.heights.are_floats()) return part * largest;
  return part * (high - low) + last_digit * largest + of_denormals;
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

bool Levels::next(const Tin& tin, double error, std::vector<Unfinished> unfinished) {
  if (cancelled_) return false;
  const std::size_t count = tin.mesh.vertex_count();
  const bool is_last = error <= last_error() || count >= options_.max_vertices;
  const auto passed = pass(error, count, is_last);
  if (passed.empty()) return false;
  TerrainLevel level{count, measure_error(grid_, tin).max, {}, std::move(unfinished)};
  for (const auto& most_vertices : passed) {
    level.most_vertices = most_vertices;
    report_.levels.push_back(level);
    if (options_.on_level) options_.on_level(tin, level);
  }
  return !is_last;
}

std::vector<std::optional<std::size_t>> Levels::pass(double error, std::size_t count,
                                                     bool is_last) {
  const auto& counts = options_.level_vertices;
  std::vector<std::optional<std::size_t>> passed;
  for (; next_error_ < options_.level_errors.size() && error <= this->error(); ++next_error_) {
    passed.emplace_back();
  }
  while (next_count_ < counts.size() && (is_last || count >= vertices())) {
    passed.emplace_back(counts[next_count_++]);
  }
  const bool has_given_up = passed.empty() && next_count_ < counts.size();
  if (has_given_up) passed.emplace_back(counts[next_count_++]);
  return passed;
}

}  // namespace lepp
