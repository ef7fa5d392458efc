#pragma once

#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// A total order on edges: by squared length as computed from the end points in lexicographic
/// order, ties by those end points. So the longest edge of a triangle does not depend on ids,
/// insertion order or threads, and a LEPP strictly grows in this key even among equal lengths.
struct EdgeKey {
  double squared_length;
  Point low, high;  ///< the ends, low < high lexicographically
  friend auto operator<=>(const EdgeKey&, const EdgeKey&) = default;
};
EdgeKey edge_key(const Mesh& mesh, HalfEdge e);

/// The edges of a triangle, shortest first, by edge_key.
std::array<HalfEdge, 3> edges_by_length(const Mesh& mesh, TriangleId t);

HalfEdge longest_edge(const Mesh& mesh, TriangleId t);
/// The same of a triangle that need not be in a mesh: the corner opposite.
std::uint32_t longest_edge(const std::array<Point, 3>& corners);

/// True if `e`, the longest edge of its triangle, ends a LEPP: it is constrained (the boundary is),
/// or it is the longest edge of the triangle across as well.
bool is_terminal(const Mesh& mesh, HalfEdge e);

struct LeppPath {
  std::vector<TriangleId> triangles;  ///< the start first; the last one owns `terminal`
  HalfEdge terminal;                  ///< the terminal edge, seen from the last triangle
};

/// Longest-edge propagation path (LEPP) of triangle `start`.
/// From `start`, step across the current triangle's longest edge until that edge is terminal. An
/// interface ends the path although a triangle lies beyond.
/// \pre     `mesh` satisfies M1 to M4; `start` is one of its triangles
/// \return  n >= 1 triangles
/// Cost     O(n). Source [rivara1997]; docs/algorithms/lepp.md maps its steps to these names.
LeppPath lepp_path(const Mesh& mesh, TriangleId start);

/// The terminal edge alone, without storing the path.
HalfEdge terminal_edge(const Mesh& mesh, TriangleId start);

}  // namespace lepp
