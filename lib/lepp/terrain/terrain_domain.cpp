#include "lepp/terrain/terrain_domain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lepp/geometry/error.hpp"
#include "lepp/terrain/outline.hpp"

namespace lepp {

namespace {

// Half the width of what is put around a sample that no cell covers: a power of two, so that all
// coordinates are exact, and at most a quarter of a cell.
double island_size(const HeightGrid& grid) {
  return std::exp2(std::floor(std::log2(std::min(1.0, grid.aspect())))) / 4;
}

void add_islands(const HeightGrid& grid, const Outline& outline, Pslg& pslg) {
  const double size = island_size(grid);
  for (const LatticePoint island : outline.islands) {
    const Point center = grid.sample(island.column, island.line);
    const std::size_t first = pslg.points.size();
    for (const Point corner : {Point{size, 0}, Point{0, size}, Point{-size, 0}, Point{0, -size}})
      pslg.points.push_back(center + corner);
    for (std::size_t k = 0; k < 4; ++k)
      pslg.segments.push_back({VertexId(first + k), VertexId(first + (k + 1) % 4), CurveId(0U)});
  }
}

Pslg pslg_of_outline(const HeightGrid& grid) {
  const Outline outline = outline_of(grid);
  Pslg pslg;
  pslg.source = grid.source;
  pslg.entities.surfaces.emplace_back().tag = 1;
  CurveEntity& curve = pslg.entities.curves.emplace_back();
  curve.tag = 1;
  curve.bounds = {SurfaceId(0U)};
  for (const LatticePoint p : outline.corners) pslg.points.push_back(grid.sample(p.column, p.line));
  for (const auto& [a, b] : outline.edges)
    pslg.segments.push_back({VertexId(a), VertexId(b), CurveId(0U)});
  add_islands(grid, outline, pslg);
  return pslg;
}

void check(const HeightGrid& grid) {
  if (grid.columns < 2 || grid.rows < 2) {
    throw InputError(grid.source,
                     "a grid of " + std::to_string(grid.columns) + " x " +
                         std::to_string(grid.rows) + " samples has no area between them",
                     "give at least two columns and two rows");
  }
}

}  // namespace

TerrainDomain terrain_domain(const HeightGrid& grid, const DomainOptions&) {
  check(grid);
  TerrainDomain domain;
  domain.pslg = pslg_of_outline(grid);
  if (domain.pslg.segments.empty()) {
    throw InputError(grid.source,
                     "all " + std::to_string(grid.size()) + " samples are without data",
                     "check the value that means no data");
  }
  domain.fixed_heights.assign(domain.pslg.points.size(), std::numeric_limits<double>::quiet_NaN());
  return domain;
}

}  // namespace lepp
