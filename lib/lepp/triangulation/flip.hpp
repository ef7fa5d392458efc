#pragma once

#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Replaces the diagonal of the quadrilateral around `e` by the other one:
///
///         b                 b
///       / | \             /   \         e = a -> b; c is the apex on its left, d across
///      c  |  d   --->    c --- d
///       \ | /             \   /
///         a                 a
///
/// Triangle ids stay; afterwards `e` is the new diagonal seen from its triangle.
/// \pre   `e` has a twin, is not constrained, and the quadrilateral is strictly convex
/// \return the new diagonal
HalfEdge flip(Mesh& mesh, HalfEdge e);

/// True if the quadrilateral around `e` is strictly convex. \pre `e` has a twin
bool is_flippable(const Mesh& mesh, HalfEdge e);

/// True if the apex across `e` is not strictly inside the circumcircle of e's triangle (exact).
/// \pre `e` has a twin
bool is_locally_delaunay(const Mesh& mesh, HalfEdge e);

/// Lawson's algorithm: flips until every unconstrained edge reachable from `suspects` is locally
/// Delaunay. Ends, because each flip lowers the surface z = x^2 + y^2 that the triangulation spans.
/// \param suspects  edges to look at; emptied. Stale entries are harmless.
/// \param changed   if given, triangles that a flip touched are appended (with repetitions)
void restore_delaunay(Mesh& mesh, std::vector<HalfEdge>& suspects,
                      std::vector<TriangleId>* changed = nullptr);

/// Flips until M6 holds everywhere. \pre M1 to M5
void make_delaunay(Mesh& mesh);

}  // namespace lepp
