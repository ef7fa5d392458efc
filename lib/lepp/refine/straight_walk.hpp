#pragma once

#include <optional>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Where a straight walk ended.
struct WayEnd {
  TriangleId triangle;              ///< the last one
  std::optional<HalfEdge> barrier;  ///< the constrained edge that bars the way, if one does
};

/// Walks straight from the middle of `t` to `p`, through unconstrained edges only. Without a
/// barrier `p` lies in the closed last triangle (unless `t` is so flat that its middle rounds to a
/// place outside). Cost O(triangles crossed)
WayEnd straight_walk(const Mesh& mesh, TriangleId t, Point p);

}  // namespace lepp
