#include "lepp/triangulation/flip.hpp"

#include <cassert>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/outer_edge.hpp"

namespace lepp {

HalfEdge flip(Mesh& mesh, HalfEdge e) {
  const HalfEdge f = *mesh.twin(e);
  assert(!mesh.is_constrained(e));
  const VertexId a = mesh.origin(e), b = mesh.destination(e);
  const VertexId c = mesh.apex(e), d = mesh.apex(f);
  //        c
  //      / | \        left triangle  t: (c, a, d), keeps the outer edges ca and ad
  //     a e|  b       right triangle u: (d, b, c), keeps the outer edges db and bc
  //      \ | /        new diagonal d -> c in t is opposite a
  //        d
  const TriangleId t = e.triangle, u = f.triangle;
  const HalfEdge ca = previous_edge(e), bc = next_edge(e);
  const HalfEdge ad = next_edge(f), db = previous_edge(f);

  const OuterEdge outer_ca(mesh, ca), outer_bc(mesh, bc), outer_ad(mesh, ad), outer_db(mesh, db);
  mesh.set_vertices(t, c, a, d);
  mesh.set_vertices(u, d, b, c);
  mesh.refresh_leaving(t);
  outer_ca.attach(mesh, {t, 2});  // c -> a, opposite d
  outer_ad.attach(mesh, {t, 0});  // a -> d, opposite c
  outer_db.attach(mesh, {u, 2});  // d -> b, opposite c
  outer_bc.attach(mesh, {u, 0});  // b -> c, opposite d
  const HalfEdge diagonal{t, 1};
  mesh.link(diagonal, {u, 1});
  mesh.set_constrained_flag(diagonal, false);
  mesh.set_constrained_flag({u, 1}, false);
  return diagonal;
}

bool is_flippable(const Mesh& mesh, HalfEdge e) {
  const HalfEdge f = *mesh.twin(e);
  const Point a = mesh.point(mesh.origin(e)), b = mesh.point(mesh.destination(e));
  const Point c = mesh.point(mesh.apex(e)), d = mesh.point(mesh.apex(f));
  return orient2d(c, a, d) > 0 && orient2d(d, b, c) > 0;
}

bool is_locally_delaunay(const Mesh& mesh, HalfEdge e) {
  const auto [a, b, c] = mesh.corners(e.triangle);
  return incircle(a, b, c, mesh.point(mesh.apex(*mesh.twin(e)))) <= 0;
}

void restore_delaunay(Mesh& mesh, std::vector<HalfEdge>& suspects,
                      std::vector<TriangleId>* changed) {
  while (!suspects.empty()) {
    const HalfEdge e = suspects.back();
    suspects.pop_back();
    if (mesh.is_constrained(e) || mesh.is_boundary(e) || is_locally_delaunay(mesh, e)) continue;
    const HalfEdge f = *mesh.twin(e);
    const TriangleId t = e.triangle, u = f.triangle;
    flip(mesh, e);  // a Delaunay violation implies a strictly convex quadrilateral
    for (const HalfEdge outer : {HalfEdge{t, 0}, HalfEdge{t, 2}, HalfEdge{u, 0}, HalfEdge{u, 2}}) {
      suspects.push_back(outer);
    }
    if (changed != nullptr) changed->insert(changed->end(), {t, u});
  }
}

void make_delaunay(Mesh& mesh) {
  std::vector<HalfEdge> suspects;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) suspects.push_back({TriangleId(t), i});
  }
  restore_delaunay(mesh, suspects);
}

}  // namespace lepp
