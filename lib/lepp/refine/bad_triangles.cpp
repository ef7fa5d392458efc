#include "lepp/refine/bad_triangles.hpp"

namespace lepp {

void BadTriangles::add(const Mesh& mesh, TriangleId t) {
  if (const auto badness = judge_(mesh, t)) queue_.push({*badness, t, mesh.vertices(t)});
}

std::optional<TriangleId> BadTriangles::worst(const Mesh& mesh) {
  while (!queue_.empty()) {
    const Entry entry = queue_.top();
    queue_.pop();
    if (mesh.vertices(entry.triangle) == entry.vertices) return entry.triangle;
  }
  return std::nullopt;
}

}  // namespace lepp
