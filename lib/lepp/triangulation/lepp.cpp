#include "lepp/triangulation/lepp.hpp"

#include <algorithm>

namespace lepp {

namespace {

EdgeKey key_between(Point p, Point q) {
  const auto [low, high] = std::minmax(p, q);
  return {squared_distance(low, high), low, high};
}

}  // namespace

EdgeKey edge_key(const Mesh& mesh, HalfEdge e) {
  return key_between(mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e)));
}

std::array<HalfEdge, 3> edges_by_length(const Mesh& mesh, TriangleId t) {
  std::array<HalfEdge, 3> edges{HalfEdge{t, 0}, HalfEdge{t, 1}, HalfEdge{t, 2}};
  std::ranges::sort(edges, {}, [&](HalfEdge e) { return edge_key(mesh, e); });
  return edges;
}

// Which end comes first only tells among equal lengths.
std::uint32_t longest_edge(const std::array<Point, 3>& corners) {
  const auto& [a, b, c] = corners;
  const std::array lengths{squared_distance(b, c), squared_distance(c, a), squared_distance(a, b)};
  const auto key = [&](std::uint32_t i) {
    return key_between(corners[next_corner(i)], corners[previous_corner(i)]);
  };
  std::uint32_t longest = 0;
  for (const std::uint32_t i : {1U, 2U}) {
    if (lengths[i] < lengths[longest]) continue;
    if (lengths[i] > lengths[longest] || key(i) > key(longest)) longest = i;
  }
  return longest;
}

HalfEdge longest_edge(const Mesh& mesh, TriangleId t) { return {t, longest_edge(mesh.corners(t))}; }

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
