#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
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

/// Cuts triangles into spans of samples. Crossings of sides with lines are rounded by less than
/// `same_place`, and a span takes samples that are as near to it: no sample between two triangles
/// is lost, and one on their side belongs to both.
class TriangleSpans {
 public:
  explicit TriangleSpans(const HeightGrid& grid) : columns_(grid.columns), rows_(grid.rows) {}

  /// Calls visit(ScanSpan) for each line that has samples in the triangle, from the south, until it
  /// returns false.
  /// \param step  visits only lines that are multiples of it
  template <class Visit>
  void operator()(std::array<TerrainCorner, 3> corners, Visit visit, std::int64_t step = 1) const;

 private:
  // A side from its lower end on, and what it gains from line to line.
  struct Side {
    double line, column, height;
    double per_line, rise;
    Side(const TerrainCorner& low, const TerrainCorner& high)
        : line(low.line), column(low.column), height(low.height) {
      const double lines = high.line - low.line;
      const double part = lines > 0 ? 1 / lines : 0;
      per_line = (high.column - low.column) * part;
      rise = (high.height - low.height) * part;
    }
    double column_at(double y) const { return column + per_line * (y - line); }
    double height_at(double y) const { return height + rise * (y - line); }
  };

  static bool is_before(const TerrainCorner& a, const TerrainCorner& b) {
    return a.line != b.line ? a.line < b.line : a.column < b.column;
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

//        high           The side from low to high is crossed by every line, the two others by
//       / |             those below and above the middle. Along a line the height changes by the
//      /  |             same everywhere: by what it does from the long side to the middle.
//  middle-+  slope
//      \ |
//        low
template <class Visit>
void TriangleSpans::operator()(std::array<TerrainCorner, 3> corners, Visit visit,
                               std::int64_t step) const {
  auto& [low, middle, high] = corners;
  if (is_before(middle, low)) std::swap(low, middle);
  if (is_before(high, middle)) std::swap(middle, high);
  if (is_before(middle, low)) std::swap(low, middle);
  const Side whole(low, high), lower(low, middle), upper(middle, high);
  const double width = middle.column - whole.column_at(middle.line);
  const bool is_wide = width > same_place || width < -same_place;
  const double slope = is_wide ? (middle.height - whole.height_at(middle.line)) / width : 0;
  const std::int64_t end = std::min(floor(high.line), rows_ - 1);
  const std::int64_t start = std::max<std::int64_t>(ceil(low.line), 0);
  for (std::int64_t line = (start + step - 1) / step * step; line <= end; line += step) {
    const auto y = static_cast<double>(line);
    const double on_whole = whole.column_at(y);
    const double on_other = y < middle.line   ? lower.column_at(y)
                            : y > middle.line ? upper.column_at(y)
                                              : middle.column;
    const double left = std::min(on_whole, on_other), right = std::max(on_whole, on_other);
    const std::int64_t first = std::max<std::int64_t>(ceil(left - same_place), 0);
    const std::int64_t last = std::min(floor(right + same_place), columns_ - 1);
    if (first > last) continue;
    const double height = whole.height_at(y) + slope * (static_cast<double>(first) - on_whole);
    if (!visit(ScanSpan{static_cast<std::uint32_t>(line), static_cast<std::uint32_t>(first),
                        static_cast<std::uint32_t>(last), height, slope})) {
      return;
    }
  }
}

/// Sides of a triangle: bit i is that opposite corner i.
using Sides = std::uint8_t;

/// Finds the worst sample of triangles above a grid. Samples without data are passed over, and so
/// are those at a corner: what a vertex is off by, no other vertex can mend. The same holds for
/// those on `hard` sides, whose heights are not the grid's: no vertex may come there.
class TriangleScan {
 public:
  /// \param on_line  how near to a hard side a sample is on it, in grid space
  explicit TriangleScan(const HeightGrid& grid, double on_line = 2 * same_place)
      : grid_(grid), spans_(grid), on_line_(on_line) {}

  /// Of equal errors the southernmost and westernmost sample. Cost O(samples + lines)
  WorstSample worst(const std::array<TerrainCorner, 3>& corners, Sides hard = 0) const;

  /// The same, but of a large triangle the worst sample of some of its lines, if that is off by
  /// more than `enough`: it then has to be divided anyway.
  WorstSample worst_or_bad(const std::array<TerrainCorner, 3>& corners, double enough,
                           Sides hard = 0) const;

  /// True if no sample of the triangle is off by more than `limit`; ends at the first that is.
  bool is_within(const std::array<TerrainCorner, 3>& corners, double limit, Sides hard = 0) const;

  /// False if `s` is in the triangle and off by more than `limit`: a quick look at a suspect.
  bool is_within_at(const std::array<TerrainCorner, 3>& corners, const TerrainCorner& s,
                    double limit) const;

 private:
  template <class Height>
  const Height* part(std::span<const Height> heights, const ScanSpan& span) const {
    return &heights[grid_.index(span.first, grid_.row_of_line(span.line))];
  }
  template <class Height>
  WorstSample worst_of_lines(std::span<const Height> heights,
                             const std::array<TerrainCorner, 3>& corners, Sides hard,
                             std::int64_t step) const;
  template <class Height>
  bool all_within(std::span<const Height> heights, const std::array<TerrainCorner, 3>& corners,
                  double limit, Sides hard) const;
  template <class Height>
  bool has_other(const Height* heights, double base, const ScanSpan& span,
                 const std::array<TerrainCorner, 3>& corners, double limit, Sides hard) const;
  bool is_on_hard_side(const std::array<TerrainCorner, 3>& corners, Sides hard, Sample s) const;
  bool is_on_side(const TerrainCorner& a, const TerrainCorner& b, Sample s) const;

  const HeightGrid& grid_;
  TriangleSpans spans_;
  double on_line_;
};

}  // namespace lepp
