#include "lepp/triangulation/edges_by_group.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace lepp {

namespace {

// One side of each edge stands for it, the same one whatever the order of the walk.
bool stands_for_edge(const Mesh& mesh, HalfEdge e) {
  const auto twin = mesh.twin(e);
  return !twin ||
         std::tuple(mesh.region(e.triangle), e) < std::tuple(mesh.region(twin->triangle), *twin);
}

}  // namespace

GroupedEdges edges_by_group(const Mesh& mesh) {
  std::vector<std::pair<GroupId, HalfEdge>> pairs;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      if (!mesh.is_constrained(e) || !stands_for_edge(mesh, e)) continue;
      for (const SegmentId s : mesh.segments_of(e)) {
        const auto curve = mesh.segments()[s.index()].curve;
        if (!curve) continue;
        for (const GroupId group : mesh.entities()[*curve].groups) pairs.emplace_back(group, e);
      }
    }
  }
  std::ranges::sort(pairs);
  // Two curves of one group may share the edge.
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

  GroupedEdges grouped;
  grouped.begin_.assign(mesh.entities().groups.size() + 1, 0);
  for (const auto& [group, e] : pairs) {
    ++grouped.begin_[group.index() + 1];
    grouped.edges_.push_back(e);
  }
  for (std::size_t g = 1; g < grouped.begin_.size(); ++g)
    grouped.begin_[g] += grouped.begin_[g - 1];
  return grouped;
}

}  // namespace lepp
