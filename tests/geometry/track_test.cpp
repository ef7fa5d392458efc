#include "lepp/geometry/track.hpp"

#include <doctest/doctest.h>

using namespace lepp;

namespace {

// A track 0, 1, ..., 6 with one detour, or none.
std::vector<std::uint32_t> vertices_with(const std::vector<Detour>& detours) {
  Track track;
  for (std::uint32_t v = 1; v < 6; ++v) track.passes.emplace_back(v);
  track.detours = detours;
  std::vector<std::uint32_t> vertices;
  for (const VertexId v : chain(track, {VertexId(0U), VertexId(6U), {}, 0, 1})) {
    vertices.push_back(v.value);
  }
  return vertices;
}

Detour detour(std::uint32_t from, std::uint32_t to, std::uint32_t through) {
  return {VertexId(from), VertexId(to), VertexId(through)};
}

using List = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("a track runs from end to end through what it passes") {
  CHECK(vertices_with({}) == List{0, 1, 2, 3, 4, 5, 6});
}

TEST_CASE("a detour leads through a new vertex, if its two vertices follow each other") {
  CHECK(vertices_with({detour(2, 3, 9)}) == List{0, 1, 2, 9, 3, 4, 5, 6});
  CHECK(vertices_with({detour(2, 4, 9)}) == List{0, 1, 2, 3, 4, 5, 6});
  CHECK(vertices_with({detour(0, 1, 8), detour(8, 1, 9)}) == List{0, 8, 9, 1, 2, 3, 4, 5, 6});
}

TEST_CASE("a detour through a vertex of the track cuts out the loop between the two visits") {
  CHECK(vertices_with({detour(3, 4, 1)}) == List{0, 1, 4, 5, 6});
  CHECK(vertices_with({detour(1, 2, 4)}) == List{0, 1, 4, 5, 6});
  CHECK(vertices_with({detour(5, 6, 0)}) == List{0, 6});
  CHECK(vertices_with({detour(2, 3, 9), detour(4, 5, 9)}) == List{0, 1, 2, 9, 5, 6});
}
