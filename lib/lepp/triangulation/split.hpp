#pragma once

#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// What an insertion changed.
struct Insertion {
  VertexId vertex;
  /// Every triangle that is new or has other corners now, without repetitions, ascending.
  std::vector<TriangleId> changed;
};

/// True if `p` lies strictly inside `t`.
bool is_inside(const Mesh& mesh, TriangleId t, Point p);

/// True if splitting `e` at `p` leaves only counter-clockwise triangles on both sides. `p` need
/// not lie on the line of `e`: a curved boundary is split at a point of the curve.
bool can_split_edge(const Mesh& mesh, HalfEdge e, Point p);

/// Splits `t` into three at `p`, then restores the Delaunay property around it.
/// \pre is_inside(mesh, t, p)
Insertion insert_in_triangle(Mesh& mesh, TriangleId t, Point p, VertexOrigin origin);

/// Splits `e` and its triangles at `p`, then restores the Delaunay property around it. A
/// constrained edge hands its record on to both halves, with `t` the curve parameter at `p`.
/// \pre can_split_edge(mesh, e, p)
Insertion insert_on_edge(Mesh& mesh, HalfEdge e, Point p, VertexOrigin origin, double t = 0.5);

/// The same without restoring anything; appends the edges opposite `p` to `suspects`.
VertexId split_triangle(Mesh& mesh, TriangleId t, Point p, VertexOrigin origin,
                        std::vector<HalfEdge>& suspects);
VertexId split_edge(Mesh& mesh, HalfEdge e, Point p, VertexOrigin origin, double t,
                    std::vector<HalfEdge>& suspects);

/// The vertex origin that a split of constrained edge `e` gives its new vertex.
VertexOrigin origin_on(const Mesh& mesh, HalfEdge e);

/// Rounds coordinates below the supported range to zero.
Point in_supported_range(Point p);

}  // namespace lepp
