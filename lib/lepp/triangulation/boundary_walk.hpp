#pragma once

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// The boundary edge after boundary edge `e`, the mesh on the left. O(degree)
inline HalfEdge next_side(const Mesh& mesh, HalfEdge e) {
  HalfEdge next = next_edge(e);
  while (const auto across = mesh.twin(next)) next = next_edge(*across);
  return next;
}

/// The one before it.
inline HalfEdge previous_side(const Mesh& mesh, HalfEdge e) {
  HalfEdge previous = previous_edge(e);
  while (const auto across = mesh.twin(previous)) previous = previous_edge(*across);
  return previous;
}

}  // namespace lepp
