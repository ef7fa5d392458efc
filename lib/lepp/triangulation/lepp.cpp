#include "lepp/triangulation/lepp.hpp"

#include <algorithm>

namespace lepp {

EdgeKey edge_key(const Mesh& mesh, HalfEdge e) {
  const auto [low, high] =
      std::minmax({mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e))});
  return {squared_distance(low, high), low, high};
}

std::array<HalfEdge, 3> edges_by_length(const Mesh& mesh, TriangleId t) {
  std::array<HalfEdge, 3> edges{HalfEdge{t, 0}, HalfEdge{t, 1}, HalfEdge{t, 2}};
  std::ranges::sort(edges, {}, [&](HalfEdge e) { return edge_key(mesh, e); });
  return edges;
}

// Which end comes first only tells among equal lengths.
HalfEdge longest_edge(const Mesh& mesh, TriangleId t) {
  const auto [a, b, c] = mesh.corners(t);
  const std::array lengths{squared_distance(b, c), squared_distance(c, a), squared_distance(a, b)};
  HalfEdge longest{t, 0};
  for (const std::uint32_t i : {1U, 2U}) {
    const double length = lengths[i], most = lengths[longest.edge];
    if (length < most) continue;
    if (length > most || edge_key(mesh, {t, i}) > edge_key(mesh, longest)) longest.edge = i;
  }
  return longest;
}

bool is_terminal(const Mesh& mesh, HalfEdge e) {
  if (mesh.is_constrained(e)) return true;
  const HalfEdge across = *mesh.twin(e);
  return longest_edge(mesh, across.triangle) == across;
}

LeppPath lepp_path(const Mesh& mesh, TriangleId start) {
  LeppPath path{{start}, longest_edge(mesh, start)};
  while (!is_terminal(mesh, path.terminal)) {  // ends: edge_key strictly grows each step
    const TriangleId next = mesh.twin(path.terminal)->triangle;
    path.triangles.push_back(next);
    path.terminal = longest_edge(mesh, next);
  }
  return path;
}

HalfEdge terminal_edge(const Mesh& mesh, TriangleId start) {
  HalfEdge e = longest_edge(mesh, start);
  while (!is_terminal(mesh, e)) e = longest_edge(mesh, mesh.twin(e)->triangle);
  return e;
}

}  // namespace lepp
