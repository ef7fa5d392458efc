#pragma once

#include <cstddef>
#include <cstdint>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// visit(HalfEdge) for each edge of a mesh once, by triangles: of an edge inside, the half that
/// comes first.
void for_each_edge(const Mesh& mesh, auto visit) {
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdge e{TriangleId(i), k};
      const auto across = mesh.twin(e);
      if (!across || e < *across) visit(e);
    }
  }
}

}  // namespace lepp
