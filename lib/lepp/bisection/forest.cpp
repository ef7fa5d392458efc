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

}  // namespace lepp
