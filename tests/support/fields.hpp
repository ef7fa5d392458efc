#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/triangulation/mesh.hpp"
#include "support/random.hpp"

// Values on meshes, and what they add up to.

namespace lepp::test {

inline double linear(Point p) { return 0.75 + 2 * p.x - 3 * p.y; }

template <class Function>
std::vector<double> at_vertices(const Mesh& mesh, Function f) {
  std::vector<double> values;
  for (const Point p : mesh.points()) values.push_back(f(p));
  return values;
}

template <class Function>
std::vector<double> at_middles(const Mesh& mesh, Function f) {
  std::vector<double> values;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    values.push_back(f((1.0 / 3) * (a + b + c)));
  }
  return values;
}

/// From -1 to 1.
inline std::vector<double> noise(std::size_t n, Random& random) {
  std::vector<double> values(n);
  for (double& value : values) value = random.real(-1, 1);
  return values;
}

inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

inline double area_of(const Mesh& mesh, TriangleId t) {
  const auto [a, b, c] = mesh.corners(t);
  return signed_area(a, b, c);
}

inline std::vector<double> areas_of(const Mesh& mesh) {
  std::vector<double> areas;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    areas.push_back(area_of(mesh, TriangleId(t)));
  }
  return areas;
}

inline std::vector<TriangleId> all_triangles(const Mesh& mesh) {
  std::vector<TriangleId> all;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) all.emplace_back(t);
  return all;
}

/// Each with a chance of one in `one_in`.
inline std::vector<TriangleId> some_triangles(const Mesh& mesh, Random& random,
                                              std::uint32_t one_in) {
  std::vector<TriangleId> chosen = all_triangles(mesh);
  std::erase_if(chosen, [&](TriangleId) { return !random.one_in(one_in); });
  return chosen;
}

}  // namespace lepp::test
