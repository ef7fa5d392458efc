#pragma once

#include <optional>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Where a point is in a mesh.
struct Location {
  TriangleId triangle;
  /// The edge of `triangle` that the point lies on exactly, if any (one of two at a vertex).
  std::optional<HalfEdge> on_edge;
};

/// The triangle that contains `p`: a walk from `hint` across edges that separate it from `p`.
/// Where the walk meets the boundary or runs too long it falls back to looking at every triangle.
/// \pre    M1 to M3, at least one triangle
/// \return nothing if `p` is outside the mesh.  Cost O(sqrt n) typical, O(n) outside.
std::optional<Location> locate(const Mesh& mesh, Point p, TriangleId hint = TriangleId(0U));

}  // namespace lepp
