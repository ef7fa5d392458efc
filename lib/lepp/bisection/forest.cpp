#include "lepp/bisection/forest.hpp"

#include <algorithm>
#include <utility>

#include "lepp/triangulation/lepp.hpp"

namespace lepp {

Forest::Forest(Mesh mesh, BisectionRule rule)
    : mesh_(std::move(mesh)),
      rule_(rule),
      roots_(mesh_.triangle_count()),
      root_vertices_(mesh_.vertex_count()),
      pairs_((roots_ + 1) / 2),
      leaves_(roots_) {
  std::ranges::fill(pairs_, Pair{});
  for (std::uint32_t t = 0; t < roots_; ++t) {
    link(t) = t;
    const std::uint32_t edge = longest_edge(mesh_, TriangleId(t)).edge;
    leaves_[t] = {t, none, static_cast<std::uint8_t>(edge), State::idle};
  }
}

TriangleId Forest::root(TriangleId t) const {
  std::uint32_t node = leaves_[t.index()].node;
  while (parent(node) != none) node = parent(node);
  return TriangleId(node);
}

std::optional<TriangleId> Forest::sibling(TriangleId t) const {
  const std::uint32_t node = leaves_[t.index()].node, other = node ^ 1U;
  if (parent(node) == none || !is_leaf(other)) return std::nullopt;
  return TriangleId(link(other));
}

std::optional<TriangleId> Forest::triangle(NodeId n) const {
  if (!is_leaf(n.value)) return std::nullopt;
  return TriangleId(link(n.value));
}

std::optional<NodeId> Forest::parent(NodeId n) const {
  const std::uint32_t above = parent(n.value);
  if (above == none) return std::nullopt;
  return NodeId(above);
}

std::optional<std::array<NodeId, 2>> Forest::children(NodeId n) const {
  if (is_leaf(n.value)) return std::nullopt;
  const std::uint32_t first = 2 * link(n.value);
  return std::array{NodeId(first), NodeId(first + 1)};
}

// Corner b of a triangle that is cut between a and b is in its second half, in the same place; the
// first half has the other two.
std::array<VertexId, 3> Forest::vertices(NodeId n) const {
  std::array<VertexId, 3> corners;
  for (std::uint32_t i = 0; i < 3; ++i) {
    std::uint32_t at = n.value;
    while (!is_leaf(at)) at = 2 * link(at) + (i == previous_corner(cut(at)) ? 1 : 0);
    corners[i] = mesh_.vertex(TriangleId(link(at)), i);
  }
  return corners;
}

std::vector<NodeId> Forest::level(std::uint32_t generation) const {
  std::vector<NodeId> found, pending;
  for (std::size_t i = roots_; i-- > 0;) pending.emplace_back(i);
  while (!pending.empty()) {  // ends: each node is taken out once
    const NodeId n = pending.back();
    pending.pop_back();
    const auto halves = children(n);
    if (!halves || this->generation(n) == generation) {
      found.push_back(n);
      continue;
    }
    pending.push_back((*halves)[1]);
    pending.push_back((*halves)[0]);
  }
  return found;
}

}  // namespace lepp
