#pragma once

#include <cstdint>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// A constrained edge in a loop: its index in MeshOutline::edges, and whether the loop runs along
/// that half-edge or against it.
struct LoopEdge {
  std::size_t edge = 0;
  bool along = true;
};
using Loop = std::vector<LoopEdge>;

/// A connected part of a mesh; constrained edges separate parts.
struct OutlinePart {
  SurfaceId region;
  std::vector<Loop> loops;            ///< simple, the part on their left; the outer one first
  std::vector<std::size_t> embedded;  ///< constrained edges with this part on both sides
};

/// The constrained edges of a mesh, joined to the loops around its parts.
struct MeshOutline {
  std::vector<HalfEdge> edges;  ///< each constrained edge once
  std::vector<OutlinePart> parts;
  std::vector<std::uint32_t> part_of_triangle;
};

/// \pre M1 to M4.  Cost O(n) for bounded vertex degree.
MeshOutline outline(const Mesh& mesh);

}  // namespace lepp
