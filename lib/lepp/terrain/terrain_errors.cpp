#include "lepp/terrain/terrain_errors.hpp"

#include <algorithm>

namespace lepp {

ErrorHeap errors_above(const TerrainMesh& terrain, double limit) {
  ErrorHeap heap(limit);
  for (std::size_t t = 0; t < terrain.mesh().triangle_count(); ++t) {
    heap.set(TriangleId(t), terrain.error(TriangleId(t)));
  }
  return heap;
}

double largest_error(const TerrainMesh& terrain, const ErrorHeap& heap) {
  double largest = 0;
  for (std::size_t t = 0; t < terrain.mesh().triangle_count(); ++t) {
    largest = std::max(largest, terrain.error(TriangleId(t)));
  }
  return heap.top() ? largest : std::min(largest, heap.limit());
}

double largest_error(const TerrainMesh& terrain, const Star& star) {
  double largest = 0;
  for (const auto& side : star.link) {
    largest = std::max(largest, terrain.error(side.edge.triangle));
  }
  return largest;
}

double error_of_star(const TerrainMesh& terrain, const Star& star, Point p) {
  const TerrainCorner center = terrain.space().corner(p, terrain.height_of(p));
  double worst = 0;
  for (const auto& side : star.link) {
    const TerrainCorner a = terrain.corner(terrain.mesh().origin(side.edge)),
                        b = terrain.corner(terrain.mesh().destination(side.edge));
    worst = std::max(worst, terrain.scan().worst({center, a, b}).error);
  }
  return worst;
}

std::size_t vertex_budget(const TerrainMesh& terrain) {
  return 8 * terrain.grid().size() + 50 * (terrain.mesh().vertex_count() + 1000);
}

}  // namespace lepp
