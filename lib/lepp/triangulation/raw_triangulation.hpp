#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "lepp/geometry/xorshift.hpp"
#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// What the kernel works on before there is a Mesh: the triangulated plane.
///
/// The convex hull is surrounded by ghost triangles, which join each hull edge to one ghost vertex
/// at infinity; so every edge has a triangle on both sides and every vertex a closed fan. The ghost
/// is always corner 2 of a ghost triangle, whose edge 2 is the hull edge, seen from outside.
/// Vertices stand in spatial order. An edge is a code, 4 * triangle + edge.
class RawTriangulation {
 public:
  using Code = std::uint32_t;
  static constexpr VertexId ghost{0xFFFFFFFFU};

  std::vector<Point> points;         ///< of the vertices
  std::vector<std::uint32_t> input;  ///< for each vertex, the input point it comes from
  TriangleArray triangles;           ///< 2 (vertices - 1) of them
  std::vector<Code> leaving;         ///< for each vertex, an edge that starts there

  static std::uint32_t triangle_of(Code e) { return e >> 2; }
  static std::uint32_t edge_of(Code e) { return e & 3; }
  static Code code(std::uint32_t t, std::uint32_t edge) { return t << 2 | edge; }
  static Code next(Code e) { return (e & 3) == 2 ? e - 2 : e + 1; }
  static Code previous(Code e) { return (e & 3) == 0 ? e + 2 : e - 1; }

  VertexId apex(Code e) const { return triangles[e >> 2].vertices[e & 3]; }
  VertexId origin(Code e) const { return apex(next(e)); }
  VertexId destination(Code e) const { return apex(previous(e)); }
  Code twin(Code e) const { return triangles[e >> 2].across_[e & 3]; }
  /// Asks the memory for triangle `t`, which will be looked at soon.
  void prefetch(std::uint32_t t) const { lepp::prefetch(&triangles[t]); }
  bool is_ghost(std::uint32_t t) const { return triangles[t].vertices[2] == ghost; }
  /// The edge that leaves the same vertex next, counter-clockwise.
  Code turn(Code e) const { return twin(previous(e)); }
  Point point(VertexId v) const { return points[v.index()]; }

  void link(Code e, Code f) {
    triangles[e >> 2].across_[e & 3] = f;
    triangles[f >> 2].across_[f & 3] = e;
  }
  /// New corners; the flags are cleared, the links are the caller's.
  void set_corners(std::uint32_t t, VertexId a, VertexId b, VertexId c) {
    triangles[t].vertices = {a, b, c};
    triangles[t].constrained_ = 0;
  }
  bool is_constrained(Code e) const { return (triangles[e >> 2].constrained_ >> (e & 3) & 1) != 0; }
  /// Flags both sides.
  void constrain(Code e) {
    const Code f = twin(e);
    triangles[e >> 2].constrained_ |= 1U << (e & 3);
    triangles[f >> 2].constrained_ |= 1U << (f & 3);
  }

  /// A number on each triangle: the connected component, once regions are being found.
  std::uint32_t label(std::uint32_t t) const { return triangles[t].region_.value; }
  void set_label(std::uint32_t t, std::uint32_t label) { triangles[t].region_ = SurfaceId(label); }

  /// Sets `leaving` from the triangles.
  void find_leaving();
  /// Makes `leaving` of the corners of `t` leave from `t`.
  void leave_from(std::uint32_t t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const VertexId v = triangles[t].vertices[i];
      if (v != ghost) leaving[v.index()] = code(t, previous_corner(i));
    }
  }
  void set_constrained(Code e, bool constrained) {
    const std::uint32_t bit = 1U << (e & 3);
    std::uint32_t& flags = triangles[e >> 2].constrained_;
    flags = constrained ? flags | bit : flags & ~bit;
  }

  /// Replaces the diagonal of the quadrilateral around `e`; keeps `leaving` right.
  /// \pre no ghost, unconstrained, strictly convex
  void flip(Code e);
  /// Flips until each edge reachable from `suspects` is constrained or locally Delaunay. Suspects
  /// are taken in random order, which keeps long cavities from needing O(k^2) flips; the result
  /// does not depend on it but where vertices are cocircular, and the order is the same every time.
  void restore_delaunay(std::vector<Code>& suspects);

  /// The edge between two vertices, seen from one of its sides. O(the smaller degree).
  /// \pre there is one
  Code edge_between(VertexId a, VertexId b) const;
  /// Moves the triangles whose label has a region out of here, as those of a mesh: with that region
  /// and with the vertices `vertex` says; links to the others become "nothing". `leaving` then
  /// holds edges of the mesh, still by vertices of this.
  TriangleArray take_triangles(const std::vector<std::optional<SurfaceId>>& of_label,
                               const std::vector<std::uint32_t>& vertex);

  struct Place {
    std::uint32_t triangle;       ///< a ghost if the point is outside the hull
    bool on_constrained = false;  ///< exactly on a constrained edge or at an end of one
  };
  /// A walk from triangle `start` to the one that holds p. Randomized, because constrained edges
  /// could make a straight rule go round in circles.
  Place locate(Point p, std::uint32_t start) const;

 private:
  /// p is a corner of `t` at which a constrained edge ends.
  bool is_constrained_vertex_at(std::uint32_t t, Point p) const;
};

}  // namespace lepp
