#include "lepp/triangulation/relocate.hpp"

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/encroached.hpp"
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

bool encroaches_beyond_link(const Mesh& mesh, const Star& star, Point p,
                            std::vector<HalfEdge>& stack) {
  stack.clear();
  for (const auto& side : star.link) stack.push_back(side.edge);
  std::size_t left = mesh.triangle_count();
  while (!stack.empty()) {  // ends: by `left`, long before by the tree that cavities are
    const HalfEdge e = stack.back();
    stack.pop_back();
    if (mesh.is_constrained(e)) {
      if (would_encroach(mesh, e, p)) return true;
      continue;
    }
    const HalfEdge f = *mesh.twin(e);
    const auto [a, b, c] = mesh.corners(f.triangle);
    if (incircle(a, b, c, p) <= 0) continue;
    if (left-- == 0) return true;
    stack.push_back(previous_edge(f));
    stack.push_back(next_edge(f));
  }
  return false;
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
