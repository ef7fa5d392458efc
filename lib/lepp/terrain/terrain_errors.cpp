#include "lepp/terrain/terrain_errors.hpp"

#include <algorithm>
#include <cmath>

#include "lepp/terrain/hard_lines.hpp"

namespace lepp {

namespace {

// What `c` is off by if it is at a sample with data, else 0.
double error_at(const SampleSpace& space, const TerrainCorner& c) {
  const Sample s = space.nearest(c);
  const double error = std::abs(space.height(s) - c.height);
  return SampleSpace::is_at(c, s) && !std::isnan(error) ? error : 0;
}

}  // namespace

ErrorHeap errors_above(const TerrainMesh& terrain, double limit) {
  ErrorHeap heap(limit);
  for (std::size_t t = 0; t < terrain.mesh().triangle_count(); ++t) {
    heap.set(TriangleId(t), terrain.error(TriangleId(t)));
  }
  return heap;
}

double largest_error(const TerrainMesh& terrain) {
  double largest = 0;
  for (std::size_t t = 0; t < terrain.mesh().triangle_count(); ++t) {
    largest = std::max(largest, terrain.error(TriangleId(t)));
  }
  return largest;
}

double largest_error(const TerrainMesh& terrain, const ErrorHeap& heap) {
  const double largest = largest_error(terrain);
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
    const Sides hard = terrain.hard_side(side.edge, 0);
    worst = std::max(worst, terrain.scan().worst({center, a, b}, hard).error);
  }
  return worst;
}

double error_at_lines(const TerrainMesh& terrain) {
  const Mesh& mesh = terrain.mesh();
  double largest = 0;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    largest = std::max(largest, error_at(terrain.space(), terrain.corner(VertexId(v))));
  }
  for (const auto& [column, row, height] : samples_on_hard_lines(terrain.grid(), terrain.tin())) {
    largest = std::max(largest, std::abs(terrain.grid().height(column, row) - height));
  }
  return largest;
}

std::size_t vertex_budget(const TerrainMesh& terrain) {
  return 8 * terrain.grid().size() + 50 * (terrain.mesh().vertex_count() + 1000);
}

}  // namespace lepp
