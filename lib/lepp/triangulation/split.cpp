#include "lepp/triangulation/split.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/flip.hpp"
#include "lepp/triangulation/outer_edge.hpp"

namespace lepp {

namespace {

Insertion finish(Mesh& mesh, VertexId v, std::vector<HalfEdge>& suspects) {
  Insertion insertion{v, {}};
  for (const HalfEdge e : suspects) insertion.changed.push_back(e.triangle);
  restore_delaunay(mesh, suspects, &insertion.changed);
  std::ranges::sort(insertion.changed);
  insertion.changed.erase(std::unique(insertion.changed.begin(), insertion.changed.end()),
                          insertion.changed.end());
  return insertion;
}

// Cuts e's triangle (a, b, c), e = a -> b, at p on e:
//
//          c                 t keeps a:  (p, c, a), its edges: ca, ap, pc
//        / | \               u is new:   (p, b, c), its edges: bc, cp, pb
//       / t|u \              edge 0 lies opposite p in both
//      a---p---b
struct Halves {
  HalfEdge at_a;  // p - a seen from t
  HalfEdge at_b;  // p - b seen from u
};

Halves cut_one_side(Mesh& mesh, HalfEdge e, VertexId p) {
  const VertexId a = mesh.origin(e), b = mesh.destination(e), c = mesh.apex(e);
  const TriangleId t = e.triangle;
  const OuterEdge bc(mesh, next_edge(e)), ca(mesh, previous_edge(e));
  mesh.set_vertices(t, p, c, a);
  const TriangleId u = mesh.add_triangle(p, b, c, mesh.region(t));
  ca.attach(mesh, {t, 0});
  bc.attach(mesh, {u, 0});
  mesh.set_constrained_flag({t, 1}, false);
  mesh.set_constrained_flag({t, 2}, false);
  mesh.link({t, 2}, {u, 1});  // p -> c in t, c -> p in u
  return {{t, 1}, {u, 2}};
}

}  // namespace

bool is_inside(const Mesh& mesh, TriangleId t, Point p) {
  const auto [a, b, c] = mesh.corners(t);
  return orient2d(a, b, p) > 0 && orient2d(b, c, p) > 0 && orient2d(c, a, p) > 0;
}

bool can_split_edge(const Mesh& mesh, HalfEdge e, Point p) {
  const Point a = mesh.point(mesh.origin(e)), b = mesh.point(mesh.destination(e));
  const auto fits = [&](Point from, Point to, Point apex) {
    return orient2d(from, p, apex) > 0 && orient2d(p, to, apex) > 0;
  };
  if (!fits(a, b, mesh.point(mesh.apex(e)))) return false;
  const auto f = mesh.twin(e);
  return !f || fits(b, a, mesh.point(mesh.apex(*f)));
}

VertexId split_triangle(Mesh& mesh, TriangleId t, Point p, VertexOrigin origin,
                        std::vector<HalfEdge>& suspects) {
  //          c
  //        / | \        t keeps edge ab: (v, a, b)
  //       / uvw \       w is new: (v, b, c)
  //      / / t \ \      u is new: (v, c, a)
  //     a --------- b
  const auto [a, b, c] = mesh.vertices(t);
  const SurfaceId region = mesh.region(t);
  const OuterEdge bc(mesh, {t, 0}), ca(mesh, {t, 1}), ab(mesh, {t, 2});
  const VertexId v = mesh.add_vertex(p, origin);
  mesh.set_vertices(t, v, a, b);
  const TriangleId w = mesh.add_triangle(v, b, c, region);
  const TriangleId u = mesh.add_triangle(v, c, a, region);
  ab.attach(mesh, {t, 0});
  bc.attach(mesh, {w, 0});
  ca.attach(mesh, {u, 0});
  mesh.set_constrained_flag({t, 1}, false);
  mesh.set_constrained_flag({t, 2}, false);
  mesh.link({t, 1}, {w, 2});  // b -> v, v -> b
  mesh.link({w, 1}, {u, 2});  // c -> v, v -> c
  mesh.link({u, 1}, {t, 2});  // a -> v, v -> a
  suspects.insert(suspects.end(), {{t, 0}, {w, 0}, {u, 0}});
  return v;
}

VertexId split_edge(Mesh& mesh, HalfEdge e, Point p, VertexOrigin origin, double t,
                    std::vector<HalfEdge>& suspects) {
  const VertexId a = mesh.origin(e), b = mesh.destination(e);
  const bool constrained = mesh.is_constrained(e);
  const auto f = mesh.twin(e);
  const VertexId v = mesh.add_vertex(p, origin);
  const Halves left = cut_one_side(mesh, e, v);
  // The edges p - c are suspects too: where p lies off the line ab, a flip may join a and b again.
  suspects.insert(suspects.end(), {{left.at_a.triangle, 0}, {left.at_b.triangle, 0}});
  suspects.push_back({left.at_a.triangle, 2});
  mesh.unlink(left.at_a);
  mesh.unlink(left.at_b);
  if (f) {
    const Halves right = cut_one_side(mesh, *f, v);  // f runs b -> a, so its "a" is b
    mesh.link(left.at_a, right.at_b);
    mesh.link(left.at_b, right.at_a);
    suspects.insert(suspects.end(), {{right.at_a.triangle, 0}, {right.at_b.triangle, 0}});
    suspects.push_back({right.at_a.triangle, 2});
    mesh.set_constrained_flag(right.at_a, constrained);
    mesh.set_constrained_flag(right.at_b, constrained);
  }
  mesh.set_constrained_flag(left.at_a, constrained);
  mesh.set_constrained_flag(left.at_b, constrained);
  if (constrained) mesh.split_record(a, b, v, t);
  return v;
}

Insertion insert_in_triangle(Mesh& mesh, TriangleId t, Point p, VertexOrigin origin) {
  assert(is_inside(mesh, t, p));
  std::vector<HalfEdge> suspects;
  const VertexId v = split_triangle(mesh, t, p, origin, suspects);
  return finish(mesh, v, suspects);
}

Insertion insert_on_edge(Mesh& mesh, HalfEdge e, Point p, VertexOrigin origin, double t) {
  assert(can_split_edge(mesh, e, p));
  std::vector<HalfEdge> suspects;
  const VertexId v = split_edge(mesh, e, p, origin, t, suspects);
  return finish(mesh, v, suspects);
}

VertexOrigin origin_on(const Mesh& mesh, HalfEdge e) {
  if (!mesh.is_constrained(e)) return {VertexOrigin::Kind::interior, 0};
  return {VertexOrigin::Kind::on_segment, mesh.constrained_edge(e).segments.value};
}

Point in_supported_range(Point p) {
  const auto round = [](double c) { return std::abs(c) < min_coordinate ? 0.0 : c; };
  return {round(p.x), round(p.y)};
}

}  // namespace lepp
