#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "lepp/terrain/simplify.hpp"

namespace lepp {

namespace {

// Samples nearer to a side than this, in cells, are on it: vertices in world coordinates are not
// where they were meant to be by about that much.
constexpr double on_side = 1e-7;

class SampleSet {
 public:
  static constexpr std::size_t bits = 64;  // of a word
  explicit SampleSet(std::size_t size) : words_((size + 63) / 64, 0) {}
  /// Of the word that begins with sample `first`.
  bool contains_all(std::size_t first) const { return words_[first / 64] == ~std::uint64_t{0}; }
  bool contains(std::size_t i) const { return (words_[i / 64] >> (i % 64) & 1U) != 0; }
  void add(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
  void add(std::size_t first, std::size_t end) {
    for (; first < end && first % 64 != 0; ++first) add(first);
    for (; first + 64 <= end; first += 64) words_[first / 64] = ~std::uint64_t{0};
    for (; first < end; ++first) add(first);
  }

 private:
  std::vector<std::uint64_t> words_;
};

// Two doubles at a time, as every machine of today does; compilers do not see that for themselves,
// because the order in which a maximum is taken matters where there are NaNs.
using Pair = double __attribute__((vector_size(16)));
using FloatPair = float __attribute__((vector_size(8)));
using Bits = std::int64_t __attribute__((vector_size(16)));

template <class Height>
Pair pair_of(const Height* heights) {
  std::conditional_t<std::is_same_v<Height, float>, FloatPair, Pair> pair;
  std::memcpy(&pair, heights, sizeof pair);
  return __builtin_convertvector(pair, Pair);
}

// How far samples are off; NaNs are passed over, as they compare false.
class Spread {
 public:
  void add(Pair off) {
    high_ = off > high_ ? off : high_;
    low_ = off < low_ ? off : low_;
    squares_ += reinterpret_cast<Pair>(reinterpret_cast<Bits>(off * off) & (off == off));
  }
  double highest() const { return std::max(high_[0], high_[1]); }
  double lowest() const { return std::min(low_[0], low_[1]); }
  double sum_of_squares() const { return squares_[0] + squares_[1]; }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  Pair high_{-infinite, -infinite}, low_{infinite, infinite}, squares_{0, 0};
};

// Column and row of the file, and a height.
struct Vertex {
  double x, y, z;
};

// One triangle after the other, one row of samples after the other. Shares nothing with the
// simplification but the grid, so that a mistake there cannot hide here.
template <class Height>
class Measure {
 public:
  Measure(const HeightGrid& grid, std::span<const Height> heights, const Tin& tin)
      : grid_(grid), heights_(heights), seen_(grid.size()) {
    error_.highest = -std::numeric_limits<double>::infinity();
    error_.lowest = std::numeric_limits<double>::infinity();
    for (const Triangle& t : tin.mesh.triangles()) {
      std::array<Vertex, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) corners[i] = vertex(tin, t.vertices[i]);
      add(corners);
    }
  }

  TerrainError result() {
    count_samples();
    if (error_.samples == 0) error_.highest = error_.lowest = 0;
    else error_.rms = std::sqrt(sum_of_squares_ / static_cast<double>(error_.samples));
    return error_;
  }

 private:
  Vertex vertex(const Tin& tin, VertexId v) const {
    const Point p = tin.mesh.point(v);
    const double line = p.y / grid_.aspect();
    return {p.x, grid_.north_first() ? grid_.rows - 1 - line : line, tin.heights[v.index()]};
  }

  void add(std::array<Vertex, 3>& v) {
    double twice_area =
        (v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[2].x - v[0].x) * (v[1].y - v[0].y);
    if (twice_area < 0) {
      std::swap(v[1], v[2]);
      twice_area = -twice_area;
    }
    if (!(twice_area > 0)) return;
    slope_ = ((v[1].z - v[0].z) * (v[2].y - v[0].y) - (v[2].z - v[0].z) * (v[1].y - v[0].y)) /
             twice_area;
    const double low = std::min({v[0].y, v[1].y, v[2].y}),
                 high = std::max({v[0].y, v[1].y, v[2].y});
    const auto first = static_cast<std::int64_t>(std::max(0.0, std::ceil(low - on_side)));
    const auto last = std::min<std::int64_t>(static_cast<std::int64_t>(std::floor(high + on_side)),
                                             grid_.rows - 1);
    for (std::int64_t row = first; row <= last; ++row) add_row(v, twice_area, row);
  }

  // The part of a row inside the triangle: right of the sides that lead down (towards larger rows
  // these are the left ones), left of those that lead up.
  void add_row(const std::array<Vertex, 3>& v, double twice_area, std::int64_t row) {
    const auto y = static_cast<double>(row);
    double left = std::numeric_limits<double>::infinity(), right = -left;
    bool along_side = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vertex& a = v[i];
      const Vertex& b = v[(i + 1) % 3];
      if (std::min(a.y, b.y) > y + on_side || std::max(a.y, b.y) < y - on_side) continue;
      const double dy = b.y - a.y;
      if (std::abs(dy) < on_side) {
        left = std::min({left, a.x, b.x});
        right = std::max({right, a.x, b.x});
        along_side = true;
        continue;
      }
      const double x = a.x + (b.x - a.x) * std::clamp((y - a.y) / dy, 0.0, 1.0);
      left = std::min(left, x);
      right = std::max(right, x);
    }
    if (!(left <= right)) return;
    const double first = std::max(0.0, std::ceil(left - on_side));
    const double last = std::min<double>(std::floor(right + on_side), grid_.columns - 1);
    if (first > last) return;
    base_ = v[0].z;
    height_ = height_at_column(v, twice_area, left, y);
    left_ = left;
    right_ = right;
    add_samples(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last),
                static_cast<std::uint32_t>(row), along_side);
  }

  static double height_at_column(const std::array<Vertex, 3>& v, double twice_area, double x,
                                 double y) {
    double sum = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      const Vertex& a = v[(i + 1) % 3];
      const Vertex& b = v[(i + 2) % 3];
      sum += ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) * (v[i].z - v[0].z);
    }
    return sum / twice_area;
  }

  // Samples on sides may have been seen from the triangle across: they count once.
  void add_samples(std::uint32_t first, std::uint32_t last, std::uint32_t row, bool along_side) {
    const std::size_t start = grid_.index(0, row);
    std::uint32_t from = first, to = last + 1;  // inside
    if (along_side) {
      to = from;
    } else {
      if (first - left_ < on_side) ++from;
      if (to > from && right_ - last < on_side) --to;
    }
    for (std::uint32_t c = first; c < from; ++c) add_on_side(c, row);
    for (std::uint32_t c = std::max(to, from); c <= last; ++c) add_on_side(c, row);
    if (from < to) {
      add_inside(from, to, row);
      seen_.add(start + from, start + to);
    }
  }

  void add_on_side(std::uint32_t column, std::uint32_t row) {
    const std::size_t i = grid_.index(column, row);
    const double height = height_ + slope_ * (std::clamp<double>(column, left_, right_) - left_);
    const double off = (heights_[i] - base_) - height;
    if (!std::isnan(off)) {
      if (!seen_.contains(i)) sum_of_squares_ += off * off;
      note(off, column, row);
    }
    seen_.add(i);
  }

  void add_inside(std::uint32_t from, std::uint32_t to, std::uint32_t row) {
    const Height* const heights = &heights_[grid_.index(from, row)];
    fetch_ahead(heights, to - from, row);
    const double start = height_ + slope_ * (from - left_);
    const std::size_t n = to - from;
    const auto off_at = [&](std::size_t i) {
      return (heights[i] - base_) - (start + slope_ * static_cast<double>(i));
    };
    const Pair base{base_, base_}, starts{start, start}, slopes{slope_, slope_}, step{4, 4};
    Pair at_first{0, 1}, at_second{2, 3};
    Spread first, second;
    std::size_t i = 0;
    for (; i + 4 <= n; i += 4) {
      first.add((pair_of(heights + i) - base) - (starts + slopes * at_first));
      second.add((pair_of(heights + i + 2) - base) - (starts + slopes * at_second));
      at_first += step;
      at_second += step;
    }
    for (; i < n; ++i) first.add(Pair{off_at(i), std::numeric_limits<double>::quiet_NaN()});
    sum_of_squares_ += first.sum_of_squares() + second.sum_of_squares();
    const double highest = std::max(first.highest(), second.highest());
    const double lowest = std::min(first.lowest(), second.lowest());
    if (!(highest > error_.highest || lowest < error_.lowest)) return;
    for (std::size_t k = 0; k < n; ++k) {
      if (const double off = off_at(k); !std::isnan(off))
        note(off, from + static_cast<std::uint32_t>(k), row);
    }
  }

  // Rows are far from each other in memory: what comes two rows later is asked for now.
  void fetch_ahead(const Height* heights, std::size_t n, std::uint32_t row) const {
    constexpr std::size_t cache_line = 64 / sizeof(Height);
    if (row + 2 >= grid_.rows) return;
    const Height* const later = heights + 2 * std::size_t{grid_.columns};
    for (std::size_t k = 0; k < n; k += cache_line) __builtin_prefetch(later + k);
  }

  void note(double off, std::uint32_t column, std::uint32_t row) {
    error_.highest = std::max(error_.highest, off);
    error_.lowest = std::min(error_.lowest, off);
    if (std::abs(off) > error_.max) {
      error_.max = std::abs(off);
      error_.column = column;
      error_.row = row;
    }
  }

  void count_samples() {
    for (std::size_t first = 0; first < grid_.size(); first += SampleSet::bits) {
      const std::size_t count = std::min(SampleSet::bits, grid_.size() - first);
      std::size_t data = 0;
      for (std::size_t k = 0; k < count; ++k) data += std::isnan(heights_[first + k]) ? 0 : 1;
      if (data == count && seen_.contains_all(first)) error_.samples += count;
      else count_one_by_one(first, first + count);
    }
  }

  void count_one_by_one(std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      const bool seen = seen_.contains(i), data = !std::isnan(heights_[i]);
      error_.samples += seen && data ? 1 : 0;
      error_.lost += !seen && data ? 1 : 0;
      error_.covered += seen && !data ? 1 : 0;
    }
  }

  const HeightGrid& grid_;
  std::span<const Height> heights_;
  SampleSet seen_;
  TerrainError error_;
  double sum_of_squares_ = 0;
  // Of the row in hand: where it enters and leaves the triangle, how high it enters, and how steep.
  // Heights are those above the first corner: then little is rounded where all are far from 0.
  double left_ = 0, right_ = 0, base_ = 0, height_ = 0, slope_ = 0;
};

}  // namespace

TerrainError measure_error(const HeightGrid& grid, const Tin& tin) {
  return grid.heights.visit([&](auto heights) { return Measure(grid, heights, tin).result(); });
}

}  // namespace lepp
