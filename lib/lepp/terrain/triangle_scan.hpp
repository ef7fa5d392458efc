#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "lepp/terrain/height_grid.hpp"
#include "lepp/terrain/sample_space.hpp"

namespace lepp {

/// The sample of a triangle where it is farthest from the grid.
struct WorstSample {
  double error = 0;  ///< |H - H*|; 0 and any sample if none is off
  Sample at;
};

/// The part of a line of samples that a triangle covers, its sides included.
struct ScanSpan {
  std::uint32_t line, first, last;  ///< columns first to last
  double height;                    ///< of the triangle at `first`
  double slope;                     ///< from column to column
};

/// Cuts triangles into spans of samples. The crossing of a side with a line is computed from its
/// ends in an order of their own, so that both triangles of a side see the same one: no sample
/// between two triangles is lost, and one on their side belongs to both.
class TriangleSpans {
 public:
  explicit TriangleSpans(const HeightGrid& grid) : columns_(grid.columns), rows_(grid.rows) {}

  /// Calls visit(ScanSpan) for each line that has samples in the triangle, from the south.
  template <class Visit>
  void operator()(std::array<TerrainCorner, 3> corners, Visit visit) const;

 private:
  struct Crossing {
    double column, height;
  };
  static bool is_before(const TerrainCorner& a, const TerrainCorner& b) {
    return a.line != b.line ? a.line < b.line : a.column < b.column;
  }
  static Crossing crossing(const TerrainCorner& low, const TerrainCorner& high, double line) {
    const double all = high.line - low.line, part = line - low.line;
    if (!(part < all)) return {high.column, high.height};
    return {low.column + (high.column - low.column) * part / all,
            low.height + (high.height - low.height) * part / all};
  }
  // ceil and floor of what is not far below 0, without a call.
  static std::int64_t ceil(double x) {
    const auto whole = static_cast<std::int64_t>(x);
    return whole + (static_cast<double>(whole) < x ? 1 : 0);
  }
  static std::int64_t floor(double x) {
    const auto whole = static_cast<std::int64_t>(x);
    return whole - (x < static_cast<double>(whole) ? 1 : 0);
  }

  std::int64_t columns_, rows_;
};

template <class Visit>
void TriangleSpans::operator()(std::array<TerrainCorner, 3> corners, Visit visit) const {
  auto& [low, middle, high] = corners;
  if (is_before(middle, low)) std::swap(low, middle);
  if (is_before(high, middle)) std::swap(middle, high);
  if (is_before(middle, low)) std::swap(low, middle);
  const std::int64_t end = std::min(floor(high.line), rows_ - 1);
  for (std::int64_t line = std::max<std::int64_t>(ceil(low.line), 0); line <= end; ++line) {
    const auto y = static_cast<double>(line);
    Crossing left = crossing(low, high, y);
    Crossing right = y <= middle.line ? crossing(low, middle, y) : crossing(middle, high, y);
    if (right.column < left.column) std::swap(left, right);
    const std::int64_t first = std::max<std::int64_t>(ceil(left.column - same_place), 0);
    const std::int64_t last = std::min(floor(right.column + same_place), columns_ - 1);
    if (first > last) continue;
    const double width = right.column - left.column;
    const double slope = width > same_place ? (right.height - left.height) / width : 0;
    visit(ScanSpan{static_cast<std::uint32_t>(line), static_cast<std::uint32_t>(first),
                   static_cast<std::uint32_t>(last),
                   left.height + slope * (static_cast<double>(first) - left.column), slope});
  }
}

/// Finds the worst sample of triangles above a grid. Samples without data are passed over, and so
/// are those at a corner: what a vertex is off by, no other vertex can mend.
class TriangleScan {
 public:
  explicit TriangleScan(const HeightGrid& grid) : grid_(grid), spans_(grid) {}

  /// Of equal errors the southernmost and westernmost sample. Cost O(samples + lines)
  WorstSample worst(const std::array<TerrainCorner, 3>& corners) const;

  /// True if no sample of the triangle is off by more than `limit`; ends at the first that is.
  bool is_within(const std::array<TerrainCorner, 3>& corners, double limit) const;

 private:
  double largest_error(const ScanSpan& span) const;

  const HeightGrid& grid_;
  TriangleSpans spans_;
};

}  // namespace lepp
