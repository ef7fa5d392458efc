#include "lepp/refine/straight_walk.hpp"

#include "lepp/geometry/predicates.hpp"

namespace lepp {

namespace {

bool is_beyond(const Mesh& mesh, HalfEdge e, Point p) {
  return orient2d(mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e)), p) < 0;
}

// The edge over which the way m -> p leaves `t`, if p lies outside.
std::optional<HalfEdge> first_exit(const Mesh& mesh, TriangleId t, Point m, Point p) {
  std::optional<HalfEdge> exit;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge e{t, i};
    if (!is_beyond(mesh, e, p)) continue;
    exit = e;
    if (orient2d(m, p, mesh.point(mesh.origin(e))) <= 0 &&
        orient2d(m, p, mesh.point(mesh.destination(e))) >= 0) {
      return exit;
    }
  }
  return exit;
}

}  // namespace

//        w          the way m -> p came in over f = b -> a; it leaves over a -> w
//      /   \        if w is on its left, else over w -> b
//    b --f--a
//       m
WayEnd straight_walk(const Mesh& mesh, TriangleId t, Point p) {
  const auto [x, y, z] = mesh.corners(t);
  const Point m{(x.x + y.x + z.x) / 3, (x.y + y.y + z.y) / 3};
  WayEnd end{t, {}};
  std::optional<HalfEdge> exit = first_exit(mesh, t, m, p);
  while (exit) {  // ends: p comes nearer along a straight line
    if (mesh.is_constrained(*exit)) {
      end.barrier = exit;
      return end;
    }
    const HalfEdge f = *mesh.twin(*exit);
    end.triangle = f.triangle;
    const bool left = orient2d(m, p, mesh.point(mesh.apex(f))) > 0;
    const HalfEdge e = left ? next_edge(f) : previous_edge(f);
    exit.reset();
    if (is_beyond(mesh, e, p)) exit = e;
  }
  return end;
}

}  // namespace lepp
