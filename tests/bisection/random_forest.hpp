#pragma once

#include <algorithm>
#include <random>
#include <vector>

#include "lepp/bisection/forest.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/fields.hpp"
#include "support/shapes.hpp"

namespace lepp::test {

/// Points with small integer coordinates, times a power of two, in a square with a chain across:
/// the middles of edges are exact for some forty generations, and the lengths for twenty.
inline Mesh integer_mesh(std::mt19937_64& random, int points, double scale = 1 << 20,
                         Point corner = {0, 0}) {
  std::uniform_int_distribution<int> coordinate(1, 62);
  const auto at = [&](int x, int y) {
    return corner + scale * Point{static_cast<double>(x), static_cast<double>(y)};
  };
  Pslg pslg;
  add_chain(pslg, {at(0, 0), at(63, 0), at(63, 63), at(0, 63)}, true);
  add_chain(pslg, {at(0, 21), at(63, 42)}, false);
  std::vector<Point> known = pslg.points;
  for (int i = 0; i < points; ++i) {
    const int x = coordinate(random), y = coordinate(random);
    const Point p = at(x, y);
    if (std::ranges::find(known, p) != known.end()) continue;
    known.push_back(p);
    pslg.points.push_back(p);
  }
  return constrained_delaunay(pslg).mesh;
}

inline std::vector<TriangleId> some_triangles(std::mt19937_64& random, const Mesh& mesh,
                                              std::size_t count) {
  std::vector<TriangleId> marked;
  for (std::size_t i = 0; i < count; ++i) marked.emplace_back(random() % mesh.triangle_count());
  return marked;
}

}  // namespace lepp::test
