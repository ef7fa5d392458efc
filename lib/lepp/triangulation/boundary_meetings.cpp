#include "lepp/triangulation/boundary_meetings.hpp"

#include <algorithm>
#include <vector>

#include "lepp/geometry/pslg.hpp"

namespace lepp {

namespace {

std::vector<HalfEdge> boundary_edges(const Mesh& mesh) {
  std::vector<HalfEdge> edges;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      if (mesh.is_boundary(e)) edges.push_back(e);
    }
  }
  return edges;
}

}  // namespace

std::optional<std::pair<HalfEdge, HalfEdge>> first_boundary_meeting(const Mesh& mesh) {
  const std::vector<HalfEdge> edges = boundary_edges(mesh);
  Pslg boundary;
  boundary.source = mesh.source();
  boundary.points.assign(mesh.points().begin(), mesh.points().end());
  for (const HalfEdge e : edges) {
    boundary.segments.push_back({mesh.origin(e), mesh.destination(e), {}, 0, 1});
  }
  const auto meeting = first_bad_meeting(boundary);
  if (!meeting) return std::nullopt;
  return std::pair(edges[meeting->first.index()], edges[meeting->second.index()]);
}

bool has_bent_boundary(const Mesh& mesh) {
  const auto& curves = mesh.entities().curves;
  const auto is_bent = [](const CurveEntity& c) { return !is_straight(c.geometry); };
  if (std::ranges::none_of(curves, is_bent)) return false;
  return std::ranges::any_of(boundary_edges(mesh), [&](HalfEdge e) {
    const auto curve = mesh.curve_of(e);
    return curve && is_bent(mesh.entities()[*curve]);
  });
}

}  // namespace lepp
