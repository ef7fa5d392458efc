#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "lepp/geometry/pslg.hpp"

namespace lepp::test {

/// A closed polygon through the given x0 y0 x1 y1 ...
inline Pslg polygon(const std::vector<double>& coordinates) {
  std::vector<std::uint32_t> segments;
  const auto n = static_cast<std::uint32_t>(coordinates.size() / 2);
  for (std::uint32_t i = 0; i < n; ++i) segments.insert(segments.end(), {i, (i + 1) % n});
  return pslg_from_arrays(coordinates, segments);
}

/// Adds an open or closed chain of segments through new points.
inline void add_chain(Pslg& pslg, const std::vector<Point>& points, bool closed) {
  const auto first = static_cast<std::uint32_t>(pslg.points.size());
  const auto n = static_cast<std::uint32_t>(points.size());
  pslg.points.insert(pslg.points.end(), points.begin(), points.end());
  for (std::uint32_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
    pslg.segments.push_back({VertexId(first + i), VertexId(first + (i + 1) % n), {}, 0, 1});
  }
}

inline Pslg unit_square() { return polygon({0, 0, 1, 0, 1, 1, 0, 1}); }

///   y
///   2 +---+        the six corners of an L
///   1 |   +---+
///   0 +-------+
///     0   1   2  x
inline Pslg l_shape() { return polygon({0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2}); }

/// The paper's Example 1 as rebuilt: a long strip with one interior segment.
inline Pslg example_1() {
  Pslg pslg = polygon({0, 0, 30.867, 0, 30.867, 1, 0, 1});
  add_chain(pslg, {{5.579, 0.439}, {25.023, 0.447}}, false);
  return pslg;
}

/// A star-shaped polygon of 3 to 22 vertices with `interfaces` free segments that meet inside it
/// at random angles.
inline Pslg random_star(std::mt19937_64& random, int interfaces = 0) {
  std::uniform_real_distribution<double> uniform;
  const int n = 3 + static_cast<int>(random() % 20);
  std::vector<double> coordinates;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.9 * uniform(random)) / n;
    const double radius = 0.2 + 0.8 * uniform(random);
    coordinates.insert(coordinates.end(), {radius * std::cos(angle), radius * std::sin(angle)});
  }
  Pslg pslg = polygon(coordinates);
  if (interfaces == 0) return pslg;
  const VertexId center(pslg.points.size());
  pslg.points.push_back({0, 0});
  for (int i = 0; i < interfaces; ++i) {
    const double angle = 2 * std::numbers::pi * uniform(random);
    const double radius = 0.05 * (0.2 + 0.8 * uniform(random));
    pslg.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    pslg.segments.push_back({center, VertexId(pslg.points.size() - 1), {}, 0, 1});
  }
  return pslg;
}

/// Points on a grid of n x n cells, rotated so that (1, 0) becomes (0.8, 0.6): hardly any of them
/// is exact in doubles, while many are collinear or cocircular up to rounding.
inline std::vector<Point> rotated_grid(int n) {
  std::vector<Point> points;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) points.push_back({0.8 * i - 0.6 * j, 0.6 * i + 0.8 * j});
  }
  return points;
}

}  // namespace lepp::test
