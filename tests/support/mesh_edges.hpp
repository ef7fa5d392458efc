#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp::test {

/// The half-edges of a mesh sorted by their two vertices, from the corners of the triangles alone.
class SortedEdges {
 public:
  struct Entry {
    std::uint64_t key;
    HalfEdge edge;
  };

  explicit SortedEdges(const Mesh& mesh);

  /// The half-edge from a to b. \pre no repeated key
  std::optional<HalfEdge> find(VertexId a, VertexId b) const;
  /// The half-edges that leave a vertex.
  std::vector<HalfEdge> leaving(VertexId a) const;
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  static std::uint64_t key(VertexId a, VertexId b) {
    return std::uint64_t{a.value} << 32 | b.value;
  }
  std::vector<Entry> entries_;
};

/// The triangles joined across unconstrained edges, numbered from 0; or joined across all edges.
struct Parts {
  std::vector<std::uint32_t> of_triangle;
  std::uint32_t count = 0;
};
enum class JoinAcross { all_edges, unconstrained_edges };
Parts parts_of(const Mesh& mesh, JoinAcross join);

}  // namespace lepp::test
