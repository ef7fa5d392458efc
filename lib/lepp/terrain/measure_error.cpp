#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "lepp/geometry/two_threads.hpp"
#include "lepp/terrain/hard_lines.hpp"
#include "lepp/terrain/simplify.hpp"

namespace lepp {

namespace {

// Samples nearer to a side than this, in cells, are on it: vertices in world coordinates are not
// where they were meant to be by about that much.
constexpr double on_side = 1e-7;

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

void note_largest(double off, std::uint32_t column, std::uint32_t row, LargestError& largest) {
  if (std::abs(off) > largest.max) largest = {std::abs(off), column, row};
}

// The corners of triangles, as columns and rows of the file.
class Corners {
 public:
  Corners(const HeightGrid& grid, const Tin& tin) : tin_(tin) {
    const double aspect = grid.aspect();
    for (const Point p : tin.mesh.points()) {
      const double line = p.y / aspect;
      rows_.push_back(grid.north_first() ? grid.rows - 1 - line : line);
    }
  }
  std::array<Vertex, 3> of(std::uint32_t triangle) const {
    std::array<Vertex, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId v = tin_.mesh.triangles()[triangle].vertices[k];
      corners[k] = {tin_.mesh.point(v).x, rows_[v.index()], tin_.heights[v.index()]};
    }
    return corners;
  }

  // Triangles by their first row, a band of rows after the other: the samples of a band stay in
  // the cache for all of them. A counting sort.
  std::vector<std::uint32_t> by_rows(std::uint32_t rows) const {
    constexpr std::uint32_t rows_of_band = 16;
    const auto band = [&](const Triangle& t) {
      double first = rows_[t.vertices[0].index()];
      for (const VertexId v : t.vertices) first = std::min(first, rows_[v.index()]);
      return static_cast<std::size_t>(std::clamp(first, 0.0, rows - 1.0)) / rows_of_band;
    };
    const auto triangles = tin_.mesh.triangles();
    std::vector<std::uint32_t> begin(rows / rows_of_band + 2, 0), order(triangles.size());
    for (const Triangle& t : triangles) ++begin[band(t) + 1];
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    for (std::uint32_t i = 0; i < order.size(); ++i) order[begin[band(triangles[i])]++] = i;
    return order;
  }

 private:
  const Tin& tin_;
  std::vector<double> rows_;  // by vertex
};

// Some rows of the grid: one triangle after the other, one row of samples after the other. Shares
// nothing with the simplification but the grid, so that a mistake there cannot hide here.
template <class Height>
class Measure {
 public:
  // Rows from `first_row` to before `end_row`.
  // `on_hard`: samples on hard lines, ascending.
  Measure(const HeightGrid& grid, std::span<const Height> heights, const SampleSet* inside,
          std::span<const std::size_t> on_hard, std::uint32_t first_row, std::uint32_t end_row)
      : grid_(grid),
        heights_(heights),
        inside_(inside),
        on_hard_(on_hard),
        first_row_(first_row),
        end_row_(end_row),
        first_sample_(grid.index(0, first_row)),
        end_sample_(grid.index(0, end_row)),
        seen_(end_sample_ - first_sample_) {
    error_.highest = -std::numeric_limits<double>::infinity();
    error_.lowest = std::numeric_limits<double>::infinity();
  }

  void run(const Corners& corners, std::span<const std::uint32_t> triangles) {
    for (const std::uint32_t t : triangles) {
      std::array<Vertex, 3> v = corners.of(t);
      add(v);
    }
    count_samples();
  }

  // With what was found in other rows, behind these.
  TerrainError result_with(const Measure& other) {
    if (other.all_.max > all_.max) all_ = other.all_;
    if (other.error_.elsewhere.max > error_.elsewhere.max) {
      error_.elsewhere = other.error_.elsewhere;
    }
    error_.highest = std::max(error_.highest, other.error_.highest);
    error_.lowest = std::min(error_.lowest, other.error_.lowest);
    error_.samples += other.error_.samples;
    error_.lost += other.error_.lost;
    error_.covered += other.error_.covered;
    const double squares = sum_of_squares_ + other.sum_of_squares_;
    if (error_.samples == 0) error_.highest = error_.lowest = 0;
    else error_.rms = std::sqrt(squares / static_cast<double>(error_.samples));
    error_.max = all_.max;
    error_.column = all_.column;
    error_.row = all_.row;
    return error_;
  }

 private:
  void add(std::array<Vertex, 3>& v) {
    double twice_area =
        (v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[2].x - v[0].x) * (v[1].y - v[0].y);
    if (twice_area < 0) {
      std::swap(v[1], v[2]);
      twice_area = -twice_area;
    }
    if (!(twice_area > 0)) return;
    const double low = std::min({v[0].y, v[1].y, v[2].y}),
                 high = std::max({v[0].y, v[1].y, v[2].y});
    const double first = std::max<double>(std::ceil(low - on_side), first_row_);
    const double last = std::min(std::floor(high + on_side), double(end_row_) - 1);
    if (first > last) return;
    slope_ = ((v[1].z - v[0].z) * (v[2].y - v[0].y) - (v[2].z - v[0].z) * (v[1].y - v[0].y)) /
             twice_area;
    for (auto row = static_cast<std::uint32_t>(first); row <= last; ++row) {
      add_row(v, twice_area, row);
    }
  }

  // The part of a row inside the triangle: right of the sides that lead down (towards larger rows
  // these are the left ones), left of those that lead up.
  void add_row(const std::array<Vertex, 3>& v, double twice_area, std::uint32_t row) {
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
    add_samples(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last), row,
                along_side);
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
    const std::size_t start = grid_.index(0, row) - first_sample_;
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
      if (!seen_.contains(i - first_sample_)) sum_of_squares_ += off * off;
      note(off, column, row);
    }
    seen_.add(i - first_sample_);
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
    const bool is_larger = std::max(highest, -lowest) > error_.elsewhere.max;
    if (!(highest > error_.highest || lowest < error_.lowest || is_larger)) return;
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
    note_largest(off, column, row, all_);
    if (!(std::abs(off) > error_.elsewhere.max)) return;
    if (std::ranges::binary_search(on_hard_, grid_.index(column, row))) return;
    note_largest(off, column, row, error_.elsewhere);
  }

  void count_samples() {
    const std::span<const Height> own =
        heights_.subspan(first_sample_, end_sample_ - first_sample_);
    for (std::size_t first = 0; first < own.size(); first += SampleSet::bits) {
      const std::size_t count = std::min(SampleSet::bits, own.size() - first);
      std::size_t data = 0;
      for (std::size_t k = 0; k < count; ++k) data += std::isnan(own[first + k]) ? 0 : 1;
      if (data == count && seen_.contains_all(first)) error_.samples += count;
      else count_one_by_one(own, first, first + count);
    }
  }

  void count_one_by_one(std::span<const Height> own, std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      const bool seen = seen_.contains(i), data = !std::isnan(own[i]);
      error_.samples += seen && data ? 1 : 0;
      const bool belongs = inside_ == nullptr || inside_->contains(first_sample_ + i);
      error_.lost += !seen && data && belongs ? 1 : 0;
      error_.covered += seen && !data ? 1 : 0;
    }
  }

  const HeightGrid& grid_;
  std::span<const Height> heights_;
  const SampleSet* inside_;
  std::span<const std::size_t> on_hard_;
  const std::uint32_t first_row_, end_row_;
  const std::size_t first_sample_, end_sample_;
  SampleSet seen_;  // from first_sample_ on
  TerrainError error_;
  LargestError all_;
  double sum_of_squares_ = 0;
  // Of the row in hand: where it enters and leaves the triangle, how high it enters, and how steep.
  // Heights are those above the first corner: then little is rounded where all are far from 0.
  double left_ = 0, right_ = 0, base_ = 0, height_ = 0, slope_ = 0;
};

// In two halves of the rows, whatever the number of threads, so that sums are the same.
template <class Height>
TerrainError measured(const HeightGrid& grid, std::span<const Height> heights, const Tin& tin,
                      const SampleSet* inside, unsigned threads) {
  constexpr std::size_t few_samples = 100'000;  // faster than a thread starts
  const Corners corners(grid, tin);
  const std::vector<std::uint32_t> triangles = corners.by_rows(grid.rows);
  const std::vector<HardSample> hard = samples_on_hard_lines(grid, tin);
  std::vector<std::size_t> on_hard;
  for (const HardSample& s : hard) on_hard.push_back(grid.index(s.column, s.row));
  const std::uint32_t middle = grid.rows / 2;
  Measure first(grid, heights, inside, on_hard, 0, middle);
  Measure second(grid, heights, inside, on_hard, middle, grid.rows);
  in_parallel(
      grid.size() < few_samples ? 1 : threads, [&] { first.run(corners, triangles); },
      [&] { second.run(corners, triangles); });
  TerrainError error = first.result_with(second);
  error.samples_on_hard_lines = hard.size();
  for (const auto& [column, row, height] : hard) {
    note_largest(grid.height(column, row) - height, column, row, error.on_hard_lines);
  }
  return error;
}

}  // namespace

TerrainError measure_error(const HeightGrid& grid, const Tin& tin, const SampleSet* inside,
                           unsigned threads) {
  return grid.heights.visit(
      [&](auto heights) { return measured(grid, heights, tin, inside, threads); });
}

}  // namespace lepp
