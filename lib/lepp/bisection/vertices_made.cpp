#include "lepp/bisection/vertices_made.hpp"

#include <algorithm>
#include <utility>

namespace lepp {
namespace {

/// Ids of all triangles.
std::vector<TriangleId> all_triangles(const Mesh& mesh) {
  std::vector<TriangleId> all;
  all.reserve(mesh.triangle_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) all.emplace_back(t);
  return all;
}

/// The triangles that were joined, by the ids they have at the end.
class JoinedTriangles {
 public:
  explicit JoinedTriangles(std::size_t triangles) : joined_(triangles, 0) {}

  std::vector<TriangleId> after(const Coarsening& coarsening) {
    std::vector<TriangleId> found;
    for (const auto& [whole, other] : coarsening.triangles) {
      joined_[whole.index()] = 1;
      found.push_back(whole);
      if (joined_.back() != 0) found.push_back(other);  // takes over the id
      joined_[other.index()] = joined_.back();
      joined_.pop_back();
    }
    std::erase_if(found, [&](TriangleId t) {  // moved since, or found twice
      return t.index() >= joined_.size() || std::exchange(joined_[t.index()], 0) == 0;
    });
    return found;
  }

 private:
  std::vector<char> joined_;
};

/// All that touch one of these triangles.
std::vector<TriangleId> around(const Mesh& mesh, const std::vector<TriangleId>& triangles) {
  std::vector<TriangleId> found;
  for (const TriangleId t : triangles) {
    for (const VertexId v : mesh.vertices(t)) {
      for_each_in_fan(mesh, v, [&](TriangleId u, std::uint32_t) { found.push_back(u); });
    }
  }
  return found;
}

}  // namespace

std::vector<NewVertex> vertices_made(Forest forest) {
  std::vector<NewVertex> removed;
  std::vector<VertexId> now;  // the id in the mesh as it was given
  now.reserve(forest.mesh().vertex_count());
  for (std::size_t v = 0; v < forest.mesh().vertex_count(); ++v) now.emplace_back(v);
  JoinedTriangles joined(forest.mesh().triangle_count());
  std::vector<TriangleId> marked = all_triangles(forest.mesh());
  while (true) {  // ends: vertices become fewer
    const Coarsening coarsening = forest.coarsen(marked);
    if (coarsening.vertices.empty()) break;
    for (const auto& [v, a, b] : coarsening.vertices) {
      removed.push_back({now[v.index()], now[a.index()], now[b.index()]});
      now[v.index()] = now.back();
      now.pop_back();
    }
    marked = around(forest.mesh(), joined.after(coarsening));
  }
  std::ranges::reverse(removed);
  return removed;
}

}  // namespace lepp
