#include "support/mesh_edges.hpp"

#include <algorithm>

namespace lepp::test {

SortedEdges::SortedEdges(const Mesh& mesh) {
  entries_.reserve(3 * mesh.triangle_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      entries_.push_back({key(mesh.origin(e), mesh.destination(e)), e});
    }
  }
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& a, const Entry& b) { return a.key < b.key; });
}

std::optional<HalfEdge> SortedEdges::find(VertexId a, VertexId b) const {
  const auto found = std::lower_bound(entries_.begin(), entries_.end(), key(a, b),
                                      [](const Entry& e, std::uint64_t k) { return e.key < k; });
  if (found == entries_.end() || found->key != key(a, b)) return std::nullopt;
  return found->edge;
}

std::vector<HalfEdge> SortedEdges::leaving(VertexId a) const {
  auto at = std::lower_bound(entries_.begin(), entries_.end(), key(a, VertexId(0U)),
                             [](const Entry& e, std::uint64_t k) { return e.key < k; });
  std::vector<HalfEdge> edges;
  for (; at != entries_.end() && at->key >> 32 == a.value; ++at) edges.push_back(at->edge);
  return edges;
}

Parts parts_of(const Mesh& mesh, JoinAcross join) {
  constexpr std::uint32_t unknown = 0xFFFFFFFFU;
  Parts parts{std::vector<std::uint32_t>(mesh.triangle_count(), unknown)};
  std::vector<TriangleId> open;
  for (std::size_t first = 0; first < mesh.triangle_count(); ++first) {
    if (parts.of_triangle[first] != unknown) continue;
    parts.of_triangle[first] = parts.count;
    open.emplace_back(first);
    while (!open.empty()) {  // each triangle is opened once
      const TriangleId t = open.back();
      open.pop_back();
      for (std::uint32_t i = 0; i < 3; ++i) {
        const auto across = mesh.twin({t, i});
        if (!across) continue;
        if (join == JoinAcross::unconstrained_edges && mesh.is_constrained({t, i})) continue;
        std::uint32_t& part = parts.of_triangle[across->triangle.index()];
        if (part != unknown) continue;
        part = parts.count;
        open.push_back(across->triangle);
      }
    }
    ++parts.count;
  }
  return parts;
}

}  // namespace lepp::test
