#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// The edges of each physical group of curves, as an index into a mesh.
/// It holds half-edges: like them, it is good until the mesh changes.
class GroupedEdges {
 public:
  /// The edges of one group, once each, ascending; none for a group of points or surfaces.
  /// Ends and triangle of an edge: mesh.origin(e), mesh.destination(e), e.triangle.
  std::span<const HalfEdge> of(GroupId group) const {
    const std::uint32_t first = begin_[group.index()];
    return {edges_.data() + first, begin_[group.index() + 1] - first};
  }

 private:
  friend GroupedEdges edges_by_group(const Mesh& mesh);
  std::vector<std::uint32_t> begin_;  // groups + 1 offsets into edges_
  std::vector<HalfEdge> edges_;
};

/// Finds the constrained edges that are pieces of a curve in a group. An edge that several curves
/// share is in the groups of all of them.
///
/// Each edge is seen from one of its sides: the only one on the boundary, so that it runs with the
/// mesh on its left and (dy, -dx) points out of the domain; on an interface the region with the
/// smaller id, so that (dy, -dx) points into the other one; inside a region the smaller triangle.
/// \pre  `mesh` satisfies M1 to M4.  Cost O(triangles + n log n) for n constrained edges
GroupedEdges edges_by_group(const Mesh& mesh);

}  // namespace lepp
