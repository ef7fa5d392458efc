#include "lepp/terrain/outline_edges.hpp"

#include <algorithm>

namespace lepp {

std::vector<std::uint32_t> next_edges(const std::vector<OutlineEdge>& edges) {
  std::vector<std::uint32_t> next(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const LatticePoint at = edges[e].end();
    const auto back = static_cast<unsigned>(edges[e].direction()) + 4;
    // The covered area lies clockwise of the way back: the next edge is the first one from there.
    unsigned least = 9;
    auto f = std::ranges::lower_bound(edges, OutlineEdge(at, Direction::east));
    for (; f != edges.end() && f->start() == at; ++f) {
      const unsigned turn = (back - static_cast<unsigned>(f->direction()) + 7) % 8 + 1;
      if (turn >= least) continue;
      least = turn;
      next[e] = static_cast<std::uint32_t>(f - edges.begin());
    }
  }
  return next;
}

}  // namespace lepp
