#include "lepp/triangulation/cavity.hpp"

#include "lepp/geometry/predicates.hpp"

namespace lepp {

bool Cavity::find(const Mesh& mesh, TriangleId t, Point p) {
  if (!grow(mesh, t, p)) return false;
  for (std::size_t i = 0; i < rim_.size(); ++i) {
    if (orient2d(p, rim_[i].from, to(i)) <= 0) return false;
  }
  return true;
}

// The triangles of a cavity make a tree, because no vertex lies inside it: so none is met twice,
// and crossing edges in order meets the rim in order. Every vertex of a constrained Delaunay
// triangulation keeps a triangle outside or an edge on the rim.
bool Cavity::grow(const Mesh& mesh, TriangleId t, Point p) {
  triangles_.assign(1, t);
  rim_.clear();
  stack_.assign({{t, 2}, {t, 1}, {t, 0}});
  while (!stack_.empty()) {  // ends: each turn takes an edge away or adds a triangle of the tree
    const HalfEdge e = stack_.back();
    stack_.pop_back();
    const bool constrained = mesh.is_constrained(e);
    const HalfEdge f = mesh.twin(e).value_or(e);
    if (!constrained) {
      const auto [a, b, c] = mesh.corners(f.triangle);
      if (incircle(a, b, c, p) > 0) {
        if (triangles_.size() == mesh.triangle_count()) return false;
        triangles_.push_back(f.triangle);
        stack_.push_back(previous_edge(f));
        stack_.push_back(next_edge(f));
        continue;
      }
    }
    const VertexId origin = mesh.origin(e);
    rim_.push_back({e, f, mesh.point(origin), origin, constrained});
  }
  return true;
}

VertexId Cavity::fill(Mesh& mesh, Point p, VertexOrigin origin) {
  const SurfaceId region = mesh.region(triangles_.front());
  const VertexId v = mesh.add_vertex(p, origin);
  const std::size_t old = triangles_.size();
  for (std::size_t i = 0; i < rim_.size(); ++i) {
    const VertexId a = rim_[i].origin, b = destination(i);
    if (i < old) mesh.replace_vertices(triangles_[i], v, a, b);
    else triangles_.push_back(mesh.add_triangle(v, a, b, region));
  }
  for (std::size_t i = 0; i < rim_.size(); ++i) {
    const TriangleId t = triangles_[i], next = triangles_[i + 1 == rim_.size() ? 0 : i + 1];
    if (rim_[i].outside == rim_[i].inside) mesh.unlink({t, 0});
    else mesh.link({t, 0}, rim_[i].outside);
    mesh.set_constrained_flag({t, 0}, rim_[i].constrained);
    mesh.link({t, 1}, {next, 2});  // b -> v, v -> b
    mesh.set_constrained_flag({t, 1}, false);
    mesh.set_constrained_flag({t, 2}, false);
  }
  // Each corner of the rim is where one of its edges starts.
  for (const TriangleId t : triangles_) mesh.refresh_leaving({t, 0});
  mesh.refresh_leaving({triangles_.front(), 2});
  return v;
}

}  // namespace lepp
