#include "lepp/terrain/triangle_scan.hpp"

#include <cmath>

namespace lepp {

namespace {

double error_at(float height, double start, double slope, double i) {
  return std::abs(static_cast<double>(height) - (start + slope * i));
}

// The largest error of n samples, 0 if none has data: a comparison with NaN is false. Lanes that do
// not wait for each other become vector instructions.
double largest_of(const float* heights, std::size_t n, double start, double slope) {
  constexpr std::size_t lanes = 4;
  double largest[lanes] = {};
  double at[lanes] = {0, 1, 2, 3};
  std::size_t i = 0;
  for (; i + lanes <= n; i += lanes) {
    for (std::size_t k = 0; k < lanes; ++k) {
      const double error = error_at(heights[i + k], start, slope, at[k]);
      largest[k] = error > largest[k] ? error : largest[k];
      at[k] += lanes;
    }
  }
  for (; i < n; ++i) {
    const double error = error_at(heights[i], start, slope, static_cast<double>(i));
    largest[0] = error > largest[0] ? error : largest[0];
  }
  return std::max(std::max(largest[0], largest[1]), std::max(largest[2], largest[3]));
}

}  // namespace

double TriangleScan::largest_error(const ScanSpan& span) const {
  const float* heights = &grid_.heights[grid_.index(span.first, grid_.row_of_line(span.line))];
  return largest_of(heights, span.last - span.first + 1, span.height, span.slope);
}

WorstSample TriangleScan::worst(const std::array<TerrainCorner, 3>& corners) const {
  WorstSample worst;
  const auto is_corner = [&](Sample s) {
    return SampleSpace::is_at(corners[0], s) || SampleSpace::is_at(corners[1], s) ||
           SampleSpace::is_at(corners[2], s);
  };
  spans_(corners, [&](const ScanSpan& span) {
    if (!(largest_error(span) > worst.error)) return;
    const float* heights = &grid_.heights[grid_.index(span.first, grid_.row_of_line(span.line))];
    for (std::uint32_t i = 0; i <= span.last - span.first; ++i) {
      const double error = error_at(heights[i], span.height, span.slope, i);
      if (error > worst.error && !is_corner({span.first + i, span.line})) {
        worst = {error, {span.first + i, span.line}};
      }
    }
  });
  return worst;
}

bool TriangleScan::is_within(const std::array<TerrainCorner, 3>& corners, double limit) const {
  return worst(corners).error <= limit;
}

}  // namespace lepp
