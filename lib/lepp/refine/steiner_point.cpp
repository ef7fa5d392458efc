#include "lepp/refine/steiner_point.hpp"

#include "lepp/triangulation/lepp.hpp"
#include "lepp/triangulation/split.hpp"

namespace lepp {

namespace {

using Where = SteinerPoint::Where;

std::optional<SteinerPoint> on_edge(const Mesh& mesh, HalfEdge e, Point p) {
  if (!can_split_edge(mesh, e, p)) return std::nullopt;
  return SteinerPoint{Where::edge, e, e.triangle, p};
}

//       c           the average of the four vertices lies inside the quadrilateral, which is
//     / t \         convex: the largest angles of both triangles are opposite `e`
//    a--e--b
//     \ u /
//       d
std::optional<SteinerPoint> at_centroid(const Mesh& mesh, HalfEdge e) {
  const HalfEdge f = *mesh.twin(e);
  const Point a = mesh.point(mesh.origin(e)), b = mesh.point(mesh.destination(e));
  const Point c = mesh.point(mesh.apex(e)), d = mesh.point(mesh.apex(f));
  const Point p = in_supported_range(midpoint(midpoint(a, b), midpoint(c, d)));
  for (const TriangleId t : {e.triangle, f.triangle}) {
    if (is_inside(mesh, t, p)) return SteinerPoint{Where::triangle, e, t, p};
  }
  return on_edge(mesh, e, p);
}

}  // namespace

std::optional<SteinerPoint> steiner_point(const Mesh& mesh, HalfEdge terminal,
                                          Placement placement) {
  if (mesh.is_constrained(terminal)) {
    return SteinerPoint{Where::constrained_edge, terminal, terminal.triangle, {}};
  }
  for (const TriangleId t : {terminal.triangle, mesh.twin(terminal)->triangle}) {
    const HalfEdge second = edges_by_length(mesh, t)[1];
    if (mesh.is_constrained(second)) return SteinerPoint{Where::constrained_edge, second, t, {}};
  }
  if (placement != Placement::midpoint) return at_centroid(mesh, terminal);
  const Point a = mesh.point(mesh.origin(terminal)), b = mesh.point(mesh.destination(terminal));
  return on_edge(mesh, terminal, in_supported_range(midpoint(a, b)));
}

}  // namespace lepp
