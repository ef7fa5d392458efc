#include "lepp/terrain/join_tins.hpp"

#include <algorithm>
#include <utility>

namespace lepp {

namespace {

std::vector<HalfEdge> boundary_of(const Mesh& mesh) {
  std::vector<HalfEdge> boundary;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdge e{TriangleId(i), k};
      if (mesh.is_boundary(e)) boundary.push_back(e);
    }
  }
  return boundary;
}

}  // namespace

void JoinedTin::add(const Tin& tile, Point shift) {
  const Mesh& mesh = tile.mesh;
  if (soup_.points.empty()) soup_.entities = mesh.entities();
  const std::vector<HalfEdge> boundary = boundary_of(mesh);
  std::vector<bool> on_boundary(mesh.vertex_count(), false);
  for (const HalfEdge e : boundary) on_boundary[mesh.origin(e).index()] = true;
  std::vector<VertexId> ids;
  ids.reserve(mesh.vertex_count());
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    ids.push_back(vertex_at(mesh.point(VertexId(i)) + shift, tile.heights[i], on_boundary[i]));
  }
  for (const Triangle& t : mesh.triangles()) {
    const auto& [a, b, c] = t.vertices;
    soup_.triangles.push_back({ids[a.index()], ids[b.index()], ids[c.index()]});
  }
  for (const HalfEdge e : boundary) {
    outline_edges_.push_back({ids[mesh.origin(e).index()], ids[mesh.destination(e).index()]});
  }
}

VertexId JoinedTin::vertex_at(Point p, double height, bool may_be_shared) {
  const VertexId next(soup_.points.size());
  const VertexId id = may_be_shared ? at_.emplace(p, next).first->second : next;
  if (id != next) return id;
  soup_.points.push_back(p);
  heights_.push_back(height);
  return id;
}

// The edges that one tile alone has: of two, each has the edge in its own direction.
std::vector<Segment> JoinedTin::outline() const {
  std::vector<std::array<VertexId, 2>> edges = outline_edges_;
  std::ranges::sort(edges);
  std::vector<Segment> segments;
  for (const auto& [a, b] : edges) {
    const bool is_shared = std::ranges::binary_search(edges, std::array{b, a});
    if (!is_shared) segments.push_back({a, b, CurveId(0U)});
  }
  return segments;
}

Tin JoinedTin::join(std::string source) {
  soup_.source = std::move(source);
  soup_.segments = outline();
  outline_edges_ = {};
  at_ = {};
  Tin tin{mesh_from_triangles(soup_).mesh, std::move(heights_)};
  soup_ = {};
  heights_ = {};
  return tin;
}

}  // namespace lepp
