#include "lepp/refine/clear_around.hpp"

#include <algorithm>
#include <functional>
#include <vector>

#include "lepp/triangulation/remove_vertex.hpp"

namespace lepp {

namespace {

// Breadth first from `center`.
std::vector<TriangleId> nearest(const Mesh& mesh, TriangleId center, std::size_t triangles) {
  std::vector<TriangleId> near{center};
  std::vector<bool> known(mesh.triangle_count(), false);
  known[center.index()] = true;
  for (std::size_t i = 0; i < near.size() && near.size() < triangles; ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto across = mesh.twin({near[i], k});
      if (!across || known[across->triangle.index()]) continue;
      known[across->triangle.index()] = true;
      near.push_back(across->triangle);
    }
  }
  return near;
}

}  // namespace

std::size_t clear_around(Mesh& mesh, std::span<const TriangleId> centers, std::size_t triangles) {
  std::vector<VertexId> steiner;
  for (const TriangleId center : centers) {
    for (const TriangleId t : nearest(mesh, center, triangles)) {
      for (const VertexId v : mesh.vertices(t)) {
        if (!mesh.is_input(v)) steiner.push_back(v);
      }
    }
  }
  std::ranges::sort(steiner, std::greater<>());  // the last vertex takes a removed one's place
  steiner.erase(std::unique(steiner.begin(), steiner.end()), steiner.end());
  std::size_t removed = 0;
  for (const VertexId v : steiner) removed += remove_vertex(mesh, v).has_value() ? 1 : 0;
  return removed;
}

}  // namespace lepp
