#include "lepp/geometry/track.hpp"

#include <algorithm>

namespace lepp {

namespace {

// Inserts `v` before place `i`. If it stands elsewhere already, the vertices behind its first
// place go, up to the second one.
void insert_without_loop(std::vector<VertexId>& vertices, std::size_t i, VertexId v) {
  const auto place = vertices.begin() + static_cast<std::ptrdiff_t>(i);
  const auto known = std::ranges::find(vertices, v);
  if (known == vertices.end()) vertices.insert(place, v);
  else if (known < place) vertices.erase(known + 1, place);
  else vertices.erase(place, known);
}

}  // namespace

std::vector<VertexId> chain(const Track& track, const Segment& s) {
  std::vector<VertexId> vertices{s.a};
  vertices.insert(vertices.end(), track.passes.begin(), track.passes.end());
  vertices.push_back(s.b);
  for (const Detour& detour : track.detours) {  // between two turns no vertex occurs twice
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      if (vertices[i - 1] != detour.from || vertices[i] != detour.to) continue;
      insert_without_loop(vertices, i, detour.through);
      break;
    }
  }
  return vertices;
}

}  // namespace lepp
