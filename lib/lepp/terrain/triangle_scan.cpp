#include "lepp/terrain/triangle_scan.hpp"

#include <cmath>
#include <cstring>
#include <type_traits>

namespace lepp {

namespace {

// A large triangle, and which of its lines are looked at first.
constexpr double many_lines = 64;
constexpr std::int64_t lines_between = 8;

double error_at(double height, double start, double slope, double i) {
  return std::abs(height - (start + slope * i));
}

// Two doubles at a time, as every machine of today does; compilers do not see that for themselves,
// because the order in which a maximum is taken matters where there are NaNs.
using Pair = double __attribute__((vector_size(16)));
using FloatPair = float __attribute__((vector_size(8)));
using Bits = std::int64_t __attribute__((vector_size(16)));

// Doubles are compared above a corner: far from 0 their differences are exact, or nearly so, where
// sums are not. To floats, which end 29 bits earlier, that makes no difference.
template <class Height>
double base_of(const std::array<TerrainCorner, 3>& corners) {
  return std::is_same_v<Height, double> ? corners[0].height : 0;
}
std::array<TerrainCorner, 3> above(double base, std::array<TerrainCorner, 3> corners) {
  for (TerrainCorner& c : corners) c.height -= base;
  return corners;
}
double above(double /*0*/, float height) { return height; }
double above(double base, double height) { return height - base; }

Pair pair_above(Pair /*0*/, const float* heights) {
  FloatPair pair;
  std::memcpy(&pair, heights, sizeof pair);
  return __builtin_convertvector(pair, Pair);
}
Pair pair_above(Pair base, const double* heights) {
  Pair pair;
  std::memcpy(&pair, heights, sizeof pair);
  return pair - base;
}

template <class Height>
Pair larger_error(Pair largest, const Height* heights, Pair base, Pair start, Pair slope, Pair at) {
  const Pair off = pair_above(base, heights) - (start + slope * at);
  const Pair error = reinterpret_cast<Pair>(reinterpret_cast<Bits>(off) & INT64_MAX);
  return error > largest ? error : largest;  // false for NaN
}

// The largest error of n samples, 0 if none has data.
template <class Height>
double largest_of(const Height* heights, std::size_t n, double base, double start, double slope) {
  constexpr std::size_t lanes = 4;
  double largest = 0;
  std::size_t i = 0;
  if (n >= 2 * lanes) {
    const Pair bases{base, base}, starts{start, start}, slopes{slope, slope}, step{lanes, lanes};
    Pair low{0, 0}, high{0, 0}, at_low{0, 1}, at_high{2, 3};
    for (; i + lanes <= n; i += lanes) {
      low = larger_error(low, heights + i, bases, starts, slopes, at_low);
      high = larger_error(high, heights + i + 2, bases, starts, slopes, at_high);
      at_low += step;
      at_high += step;
    }
    largest = std::max(std::max(low[0], low[1]), std::max(high[0], high[1]));
  }
  for (; i < n; ++i) {
    const double error = error_at(above(base, heights[i]), start, slope, static_cast<double>(i));
    largest = error > largest ? error : largest;
  }
  return largest;
}

bool is_at_sample(const TerrainCorner& c) {
  return c.column == static_cast<double>(static_cast<std::int64_t>(c.column)) &&
         c.line == static_cast<double>(static_cast<std::int64_t>(c.line));
}

// One pass over a few samples is faster than a quick one and perhaps a second.
bool is_long(const ScanSpan& span) { return span.last - span.first >= 8; }

bool is_corner(const std::array<TerrainCorner, 3>& corners, Sample s) {
  return SampleSpace::is_at(corners[0], s) || SampleSpace::is_at(corners[1], s) ||
         SampleSpace::is_at(corners[2], s);
}

template <class Height>
double largest_error(const Height* heights, double base, const ScanSpan& span) {
  return largest_of(heights, span.last - span.first + 1, base, span.height, span.slope);
}

}  // namespace

bool TriangleScan::is_on_side(const TerrainCorner& a, const TerrainCorner& b, Sample s) const {
  const double aspect = grid_.aspect();
  const Point p{a.column, a.line * aspect}, q{b.column, b.line * aspect};
  const Point at = grid_.sample(s.column, s.line);
  const double part = std::clamp(dot(at - p, q - p) / squared_distance(p, q), 0.0, 1.0);
  return squared_distance(at, p + part * (q - p)) <= on_line_ * on_line_;
}

bool TriangleScan::is_on_hard_side(const std::array<TerrainCorner, 3>& corners, Sides hard,
                                   Sample s) const {
  for (std::size_t i = 0; i < 3; ++i) {
    const bool is_hard = (hard >> i & 1U) != 0;
    if (is_hard && is_on_side(corners[(i + 1) % 3], corners[(i + 2) % 3], s)) return true;
  }
  return false;
}

WorstSample TriangleScan::worst(const std::array<TerrainCorner, 3>& corners, Sides hard) const {
  return grid_.heights.visit(
      [&](auto heights) { return worst_of_lines(heights, corners, hard, 1); });
}

WorstSample TriangleScan::worst_or_bad(const std::array<TerrainCorner, 3>& corners, double enough,
                                       Sides hard) const {
  const auto [low, high] = std::minmax({corners[0].line, corners[1].line, corners[2].line});
  if (high - low >= many_lines) {
    const WorstSample some = grid_.heights.visit(
        [&](auto heights) { return worst_of_lines(heights, corners, hard, lines_between); });
    if (some.error > enough) return some;
  }
  return worst(corners, hard);
}

template <class Height>
WorstSample TriangleScan::worst_of_lines(std::span<const Height> heights,
                                         const std::array<TerrainCorner, 3>& corners, Sides hard,
                                         std::int64_t step) const {
  WorstSample worst;
  const double base = base_of<Height>(corners);
  const auto note = [&](const ScanSpan& span) {
    const Height* const along = part(heights, span);
    if (is_long(span) && !(largest_error(along, base, span) > worst.error)) return true;
    for (std::uint32_t i = 0; i <= span.last - span.first; ++i) {
      const double error = error_at(above(base, along[i]), span.height, span.slope, i);
      const Sample s{span.first + i, span.line};
      if (error > worst.error && !is_corner(corners, s) &&
          (hard == 0 || !is_on_hard_side(corners, hard, s))) {
        worst = {error, s};
      }
    }
    return true;
  };
  spans_(above(base, corners), note, step);
  return worst;
}

bool TriangleScan::is_within(const std::array<TerrainCorner, 3>& corners, double limit,
                             Sides hard) const {
  return grid_.heights.visit(
      [&](auto heights) { return all_within(heights, corners, limit, hard); });
}

// True if a sample that is not passed over is off by more than `limit`.
template <class Height>
bool TriangleScan::has_other(const Height* heights, double base, const ScanSpan& span,
                             const std::array<TerrainCorner, 3>& corners, double limit,
                             Sides hard) const {
  for (std::uint32_t i = 0; i <= span.last - span.first; ++i) {
    const Sample s{span.first + i, span.line};
    if (error_at(above(base, heights[i]), span.height, span.slope, i) > limit &&
        !is_corner(corners, s) && (hard == 0 || !is_on_hard_side(corners, hard, s))) {
      return true;
    }
  }
  return false;
}

template <class Height>
bool TriangleScan::all_within(std::span<const Height> heights,
                              const std::array<TerrainCorner, 3>& corners, double limit,
                              Sides hard) const {
  bool within = true;
  const double base = base_of<Height>(corners);
  spans_(above(base, corners), [&](const ScanSpan& span) {
    const Height* const along = part(heights, span);
    const bool suspect = !is_long(span) || largest_error(along, base, span) > limit;
    within = !suspect || !has_other(along, base, span, corners, limit, hard);
    return within;
  });
  return within;
}

bool TriangleScan::is_within_at(const std::array<TerrainCorner, 3>& corners, const TerrainCorner& s,
                                double limit) const {
  if (!is_at_sample(s)) return true;
  const auto& [a, b, c] = corners;
  const auto twice_area = [](const TerrainCorner& p, const TerrainCorner& q,
                             const TerrainCorner& r) {
    return (q.column - p.column) * (r.line - p.line) - (r.column - p.column) * (q.line - p.line);
  };
  const double at_a = twice_area(b, c, s), at_b = twice_area(c, a, s), at_c = twice_area(a, b, s);
  if (!(at_a > 0 && at_b > 0 && at_c > 0)) return true;
  const double height =
      (at_a * a.height + at_b * b.height + at_c * c.height) / (at_a + at_b + at_c);
  return !(std::abs(s.height - height) > limit);
}

}  // namespace lepp
