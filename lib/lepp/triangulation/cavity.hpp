#pragma once

#include <span>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// The cavity of a point: the triangles whose circumcircle holds it, reached from the triangle that
/// contains it without crossing a constrained edge. Inserting the point replaces them by the star
/// that joins it to the rim, and the mesh stays constrained Delaunay, without a single flip:
///
///      d-----c              d-----c
///     / \   / \            / \   / \        the rim is a b c d, counter-clockwise; rim edge
///    /   \ /   \   --->   /   v     \       i becomes edge 0 of triangle (v, a, b)
///   a-----------b        a-----------b
///
/// Keeps its memory from one point to the next.
class Cavity {
 public:
  struct RimEdge {
    HalfEdge inside;   ///< seen from the cavity, before fill()
    HalfEdge outside;  ///< seen from beyond; `inside` again on the boundary of the mesh
    Point from;        ///< where it starts: the place of `origin`
    VertexId origin;
    bool constrained;
  };

  /// Finds the cavity of `p`. \pre `p` lies in the closed triangle t, not on a constrained edge
  /// \return false if no vertex can be put there: `p` is a vertex, or lies on a constrained edge;
  ///         rim() is good for asking all the same
  bool find(const Mesh& mesh, TriangleId t, Point p);

  /// The rim, counter-clockwise, as found last.
  std::span<const RimEdge> rim() const { return rim_; }
  VertexId destination(std::size_t rim_edge) const {
    return rim_[rim_edge + 1 == rim_.size() ? 0 : rim_edge + 1].origin;
  }
  Point to(std::size_t rim_edge) const {
    return rim_[rim_edge + 1 == rim_.size() ? 0 : rim_edge + 1].from;
  }
  std::span<const TriangleId> triangles() const { return triangles_; }

  /// Puts a vertex at the point, or at `p`, another one that sees all of the rim from its left
  /// (then the caller restores the Delaunay property). Afterwards triangles() is its star, in the
  /// order of the rim. \pre find() returned true, nothing changed since
  VertexId fill(Mesh& mesh, Point p, VertexOrigin origin);

 private:
  bool grow(const Mesh& mesh, TriangleId t, Point p);
  std::vector<TriangleId> triangles_;
  std::vector<RimEdge> rim_;
  std::vector<HalfEdge> stack_;
};

}  // namespace lepp
