#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// The triangles around a vertex that ends no constrained edge, or around a point that is to
/// become one.
struct Star {
  struct LinkEdge {
    HalfEdge edge;  ///< opposite the center, seen from its triangle
    Point from;     ///< where it starts
    bool constrained;
  };
  std::vector<LinkEdge> link;  ///< counter-clockwise

  std::size_t size() const { return link.size(); }
  Point from(std::size_t i) const { return link[i].from; }
  Point to(std::size_t i) const { return link[i + 1 == link.size() ? 0 : i + 1].from; }
  void add(const Mesh& mesh, HalfEdge outer) {
    link.push_back({outer, mesh.point(mesh.origin(outer)), mesh.is_constrained(outer)});
  }
};

/// Makes `star` the star of corner `corner` of `t`, from `t` on; it keeps its memory.
/// \return false if an edge at that vertex is constrained, or it has more than `most` of them
bool find_star(const Mesh& mesh, TriangleId t, std::uint32_t corner, Star& star,
               std::size_t most = std::numeric_limits<std::size_t>::max());

/// True if every triangle of the star is counter-clockwise (exact) with its center at `p`.
bool sees_link(const Star& star, Point p);

/// True if a constrained edge is encroached by a vertex at `p` once the mesh is Delaunay around it:
/// flips join it to what lies beyond the link, as far as circumcircles hold it.
/// \param stack  memory to work with
bool encroaches_beyond_link(const Mesh& mesh, const Star& star, Point p,
                            std::vector<HalfEdge>& stack);

/// Moves `v`, the center of `star`, to `p`, and makes the mesh constrained Delaunay again.
/// \pre    sees_link(star, p); nothing has changed since find_star()
/// \param changed  triangles with other corners or coordinates are appended, perhaps repeatedly
/// Cost    O(degree) where `p` is near
void move_vertex(Mesh& mesh, VertexId v, const Star& star, Point p,
                 std::vector<TriangleId>& changed);

}  // namespace lepp
