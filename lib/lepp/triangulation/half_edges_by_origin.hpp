#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Where half-edges lead, in one array by the vertex they leave: what the triangles say, whatever
/// the links between them do.
class HalfEdgesByOrigin {
 public:
  /// \pre  the vertices of triangles are in range (M1).  Cost O(triangles log(degree))
  explicit HalfEdgesByOrigin(const Mesh& mesh);

  /// Does a half-edge lead from a to b?
  bool has(VertexId a, VertexId b) const;
  /// The half-edges with the same two ends as one of an earlier triangle. Empty for a mesh.
  std::vector<HalfEdge> repeated() const;

 private:
  static constexpr std::size_t few = 12;  // shorter lists are searched as they are

  std::span<const VertexId> destinations(VertexId v) const {
    const std::uint32_t first = begin_[v.index()];
    return {destinations_.data() + first, begin_[v.index() + 1] - first};
  }
  bool has_equal(VertexId v) const;

  const Mesh& mesh_;
  std::vector<std::uint32_t> begin_;    // vertices + 1
  std::vector<VertexId> destinations_;  // lists longer than `few` ascend
};

}  // namespace lepp
