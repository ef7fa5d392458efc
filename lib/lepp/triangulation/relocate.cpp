#include "lepp/triangulation/relocate.hpp"

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/flip.hpp"

namespace lepp {

bool find_star(const Mesh& mesh, TriangleId t, std::uint32_t corner, Star& star, std::size_t most) {
  star.link.clear();
  HalfEdge outer{t, corner};
  do {
    const HalfEdge spoke = next_edge(outer);  // arrives at the center
    if (mesh.is_constrained(spoke) || star.size() == most) return false;
    star.add(mesh, outer);
    outer = next_edge(*mesh.twin(spoke));
  } while (outer.triangle != t);
  return true;
}

bool sees_link(const Star& star, Point p) {
  for (std::size_t i = 0; i < star.size(); ++i) {
    if (orient2d(p, star.from(i), star.to(i)) <= 0) return false;
  }
  return true;
}

void move_vertex(Mesh& mesh, VertexId v, const Star& star, Point p,
                 std::vector<TriangleId>& changed) {
  mesh.move_vertex(v, p);
  std::vector<HalfEdge> suspects;
  suspects.reserve(2 * star.size());
  for (const auto& [outer, from, constrained] : star.link) {
    changed.push_back(outer.triangle);
    suspects.push_back(outer);
    suspects.push_back(next_edge(outer));  // one spoke of each triangle
  }
  restore_delaunay(mesh, suspects, &changed);
}

}  // namespace lepp
