#pragma once

// Turning around a vertex; included by mesh.hpp.

#include <type_traits>

namespace lepp {

/// From a half-edge that leaves v, the half-edge that leaves v next, counter-clockwise:
///
///        w          e  = v -> u, triangle (v, u, w)
///       / \         turn = v -> w as seen from the triangle beyond vw
///      /   \        nothing if vw is on the boundary
///     v --e-- u
inline std::optional<HalfEdge> turn_counter_clockwise(const Mesh& mesh, HalfEdge e) {
  return mesh.twin(previous_edge(e));
}

/// The other way: from v -> u to the half-edge that leaves v in the triangle across vu.
inline std::optional<HalfEdge> turn_clockwise(const Mesh& mesh, HalfEdge e) {
  const auto across = mesh.twin(e);
  if (!across) return std::nullopt;
  return next_edge(*across);
}

/// The most clockwise half-edge of the fan of e's origin, or `e` itself if the fan is closed.
inline HalfEdge first_of_fan(const Mesh& mesh, HalfEdge e) {
  HalfEdge first = e;
  while (const auto clockwise = turn_clockwise(mesh, first)) {
    if (*clockwise == e) return e;
    first = *clockwise;
  }
  return first;
}

template <class Visit>
void for_each_in_fan(const Mesh& mesh, VertexId v, Visit visit) {
  const HalfEdge first = first_of_fan(mesh, mesh.leaving(v));
  std::optional<HalfEdge> e = first;
  do {
    const std::uint32_t corner = next_corner(e->edge);  // edge i starts at corner i + 1
    if constexpr (std::is_same_v<decltype(visit(e->triangle, corner)), bool>) {
      if (!visit(e->triangle, corner)) return;
    } else {
      visit(e->triangle, corner);
    }
    e = turn_counter_clockwise(mesh, *e);
  } while (e && *e != first);
}

}  // namespace lepp
