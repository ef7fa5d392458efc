#include "lepp/triangulation/half_edges_by_origin.hpp"

#include <algorithm>
#include <tuple>

namespace lepp {

HalfEdgesByOrigin::HalfEdgesByOrigin(const Mesh& mesh)
    : mesh_(mesh), begin_(mesh.vertex_count() + 1, 0), destinations_(3 * mesh.triangle_count()) {
  for (const Triangle& t : mesh.triangles()) {
    for (const VertexId v : t.vertices) ++begin_[v.index()];
  }
  std::uint32_t end = 0;
  for (std::uint32_t& begin : begin_) begin = end += begin;  // the end, so far
  for (std::size_t t = mesh.triangle_count(); t-- > 0;) {    // which moves down to the beginning
    const auto& v = mesh.vertices(TriangleId(t));
    for (std::uint32_t i = 3; i-- > 0;) destinations_[--begin_[v[i].index()]] = v[next_corner(i)];
  }
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const auto first = destinations_.begin() + begin_[v],
               last = destinations_.begin() + begin_[v + 1];
    if (static_cast<std::size_t>(last - first) > few) std::sort(first, last);
  }
}

bool HalfEdgesByOrigin::has(VertexId a, VertexId b) const {
  const auto here = destinations(a);
  if (here.size() > few) return std::ranges::binary_search(here, b);
  return std::ranges::find(here, b) != here.end();
}

bool HalfEdgesByOrigin::has_equal(VertexId v) const {
  const auto here = destinations(v);
  if (here.size() > few) return std::ranges::adjacent_find(here) != here.end();
  for (std::size_t i = 1; i < here.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (here[i] == here[k]) return true;
    }
  }
  return false;
}

std::vector<HalfEdge> HalfEdgesByOrigin::repeated() const {
  std::vector<bool> suspect(mesh_.vertex_count(), false);
  bool any = false;
  for (std::size_t v = 0; v < suspect.size(); ++v) {
    suspect[v] = has_equal(VertexId(v));
    any |= suspect[v];
  }
  if (!any) return {};
  std::vector<std::tuple<VertexId, VertexId, HalfEdge>> sides;
  for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      if (!suspect[mesh_.origin(e).index()]) continue;
      sides.emplace_back(mesh_.origin(e), mesh_.destination(e), e);
    }
  }
  std::ranges::sort(sides);
  std::vector<HalfEdge> found;
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const auto& [a, b, e] = sides[i];
    if (std::get<0>(sides[i - 1]) == a && std::get<1>(sides[i - 1]) == b) found.push_back(e);
  }
  return found;
}

}  // namespace lepp
