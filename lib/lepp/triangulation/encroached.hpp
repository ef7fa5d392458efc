#pragma once

#include <optional>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// True if the angle opposite `e` in its triangle is above 90 degrees (exact), that is, if the
/// apex lies strictly inside the diametral circle of `e`.
bool faces_obtuse_angle(const Mesh& mesh, HalfEdge e);

/// Encroached: a vertex on either side sees the constrained edge `e` under an angle above 90
/// degrees. In a CDT the apices are the vertices that see it under the largest angle, so this one
/// predicate is both "encroached" and "an obtuse angle opposite a constrained edge".
/// \pre is_constrained(e)
bool is_encroached(const Mesh& mesh, HalfEdge e);

/// The same question for a point that is not a vertex: does `p` lie strictly inside the diametral
/// circle of `e`?
bool would_encroach(const Mesh& mesh, HalfEdge e, Point p);

/// Constrained edges that a vertex at `p` would see under more than 90 degrees, if it were
/// inserted in triangle `t` with Delaunay flips: those on the rim of its cavity.
/// \pre  p lies in the closed triangle t.  Cost O(cavity)
std::vector<HalfEdge> edges_encroached_by(const Mesh& mesh, TriangleId t, Point p);

/// A queue of constrained edges to be looked at, first in first out. Holds vertex pairs, so that
/// flips and splits elsewhere do not disturb it.
class EncroachedEdges {
 public:
  /// All encroached edges of the mesh, in triangle order.
  explicit EncroachedEdges(const Mesh& mesh);
  /// Adds the encroached edges of triangles that changed.
  void update(const Mesh& mesh, const std::vector<TriangleId>& changed);
  /// The next edge that is still there and still encroached.
  std::optional<HalfEdge> next(const Mesh& mesh);

 private:
  void add(const Mesh& mesh, TriangleId t);
  struct Entry {
    VertexId a, b;
    TriangleId triangle;  ///< where the edge was when it was queued
  };
  std::vector<Entry> entries_;
  std::size_t first_ = 0;
};

}  // namespace lepp
