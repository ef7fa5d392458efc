#include "lepp/terrain/free_stars.hpp"

namespace lepp {

bool FreeStars::find(TriangleId t, std::uint32_t corner, Star& star) {
  constexpr std::uint8_t most_moves = 20;
  const VertexId v = mesh_.vertex(t, corner);
  if (!is_free(mesh_, v, frozen_)) return false;
  if (moves_.size() <= v.index()) moves_.resize(2 * mesh_.vertex_count(), 0);
  return moves_[v.index()] < most_moves && find_star(mesh_, t, corner, star, most_triangles);
}

}  // namespace lepp
