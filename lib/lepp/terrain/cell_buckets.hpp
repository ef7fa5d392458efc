#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "lepp/terrain/height_grid.hpp"

namespace lepp {

/// Things by the cell of the grid that they are in, a cell around the grid included; in grid space.
/// What is farther out is in none.
class CellBuckets {
 public:
  explicit CellBuckets(const HeightGrid& grid)
      : aspect_(grid.aspect()), columns_(grid.columns), rows_(grid.rows) {}

  /// True if a place is in one of the cells.
  bool has(Point p) const {
    const double line = p.y / aspect_;
    return p.x >= -1 && p.x <= columns_ && line >= -1 && line <= rows_;
  }

  /// Adds a place, or a segment and all within `reach` of it.
  void add(Point p, std::uint32_t thing) {
    if (has(p)) of_cell_[cell(std::floor(p.x), std::floor(p.y / aspect_))].push_back(thing);
  }
  void add(Point a, Point b, double reach, std::uint32_t thing) {
    for_each_cell(a, b, reach, [&](std::uint64_t c) { of_cell_[c].push_back(thing); });
  }

  /// Calls visit(thing), perhaps more than once, for all within `reach` of the place or segment.
  template <class Visit>
  void near(Point p, double reach, Visit visit) const {
    near(p, p, reach, visit);
  }
  template <class Visit>
  void near(Point a, Point b, double reach, Visit visit) const {
    for_each_cell(a, b, reach, [&](std::uint64_t c) {
      const auto found = of_cell_.find(c);
      if (found == of_cell_.end()) return;
      for (const std::uint32_t thing : found->second) visit(thing);
    });
  }

 private:
  static std::uint64_t cell(double column, double line) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(line) + 1) << 32 |
           static_cast<std::uint64_t>(static_cast<std::int64_t>(column) + 1);
  }

  // Slab by slab along the longer side of its box; `reach` is in grid space.
  template <class Visit>
  void for_each_cell(Point a, Point b, double reach, Visit visit) const {
    a.y /= aspect_;
    b.y /= aspect_;
    const double across = reach / aspect_;
    const bool is_wide = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
    const double reach_along = is_wide ? reach : across, reach_beside = is_wide ? across : reach;
    const double most_along = is_wide ? columns_ : rows_, most_beside = is_wide ? rows_ : columns_;
    if (!is_wide) {
      std::swap(a.x, a.y);
      std::swap(b.x, b.y);
    }
    if (a.x > b.x) std::swap(a, b);
    const double slope = b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0;
    const double first = std::max(std::floor(a.x - reach_along), -1.0);
    const double last = std::min(std::floor(b.x + reach_along), most_along);
    for (double slab = first; slab <= last; ++slab) {
      const double from = std::clamp(slab, a.x, b.x), to = std::clamp(slab + 1, a.x, b.x);
      const auto [low, high] = std::minmax({a.y + slope * (from - a.x), a.y + slope * (to - a.x)});
      const double end = std::min(std::floor(high + 2 * reach_beside), most_beside);
      for (double k = std::max(std::floor(low - 2 * reach_beside), -1.0); k <= end; ++k) {
        visit(is_wide ? cell(slab, k) : cell(k, slab));
      }
    }
  }

  double aspect_, columns_, rows_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> of_cell_;
};

}  // namespace lepp
