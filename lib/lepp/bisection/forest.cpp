#include "lepp/bisection/forest.hpp"

#include <utility>

#include "lepp/triangulation/lepp.hpp"

namespace lepp {

namespace {

// Room to grow, so that a first call does not move arrays as large as the mesh.
constexpr double room = 1.5;

std::size_t with_room(std::size_t count) {
  return static_cast<std::size_t>(room * static_cast<double>(count));
}

}  // namespace

Forest::Forest(Mesh mesh, BisectionRule rule)
    : mesh_(std::move(mesh)),
      rule_(rule),
      roots_(mesh_.triangle_count()),
      root_vertices_(mesh_.vertex_count()) {
  mesh_.reserve(with_room(root_vertices_), with_room(roots_));
  nodes_.reserve(2 * with_room(roots_));
  node_.reserve(with_room(roots_));
  cut_.reserve(with_room(roots_));
  state_.reserve(with_room(roots_));
  half_.reserve(with_room(roots_));
  for (std::uint32_t t = 0; t < roots_; ++t) {
    nodes_.push_back({none, none, t, 0, 0});
    node_.push_back(t);
    cut_.push_back(static_cast<std::uint8_t>(longest_edge(mesh_, TriangleId(t)).edge));
  }
  state_.resize(roots_, State::idle);
  half_.resize(roots_, none);
}

TriangleId Forest::root(TriangleId t) const {
  std::uint32_t node = node_[t.index()];
  while (nodes_[node].parent != none) node = nodes_[node].parent;
  return TriangleId(node);
}

std::optional<TriangleId> Forest::sibling(TriangleId t) const {
  const std::uint32_t node = node_[t.index()], parent = nodes_[node].parent;
  if (parent == none) return std::nullopt;
  const std::uint32_t first = nodes_[parent].children;
  const std::uint32_t leaf = nodes_[node == first ? first + 1 : first].leaf;
  return leaf == none ? std::nullopt : std::optional(TriangleId(leaf));
}

}  // namespace lepp
