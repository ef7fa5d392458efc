#include "lepp/terrain/terrain_domain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "lepp/geometry/error.hpp"
#include "lepp/terrain/cut_domain.hpp"
#include "lepp/terrain/domain_lines.hpp"
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

// All segments are of curve 0.
Pslg pslg_of_outline(const HeightGrid& grid) {
  const Outline outline = outline_of(grid);
  Pslg pslg;
  pslg.source = grid.source;
  pslg.entities.curves.emplace_back().tag = 1;
  for (const LatticePoint p : outline.corners) pslg.points.push_back(grid.sample(p.column, p.line));
  for (const auto& [a, b] : outline.edges)
    pslg.segments.push_back({VertexId(a), VertexId(b), CurveId(0U)});
  add_islands(grid, outline, pslg);
  return pslg;
}

// Curve 0 bounds the only surface, so that every place inside an odd number of rings is in it:
// neither holes nor parts need a point inside.
void name_entities(Entities& entities) {
  entities.groups = {{1, 1, "outline"}, {2, 1, "terrain"}};
  SurfaceEntity& surface = entities.surfaces.emplace_back();
  surface.tag = 1;
  surface.groups = {GroupId(1U)};
  entities.curves[0].groups = {GroupId(0U)};
  entities.curves[0].bounds = {SurfaceId(0U)};
  if (entities.curves.size() == 1) return;
  entities.groups.push_back({1, 2, "breaklines"});
  for (std::size_t i = 1; i < entities.curves.size(); ++i)
    entities.curves[i].groups = {GroupId(2U)};
}

}  // namespace

TerrainDomain terrain_domain(const HeightGrid& grid, const DomainOptions& options) {
  check_usable(grid);
  Pslg outline = pslg_of_outline(grid);
  TerrainDomain domain;
  if (options.clip.empty() && options.breaklines.empty()) {
    domain.pslg = std::move(outline);
    domain.fixed_heights.assign(domain.pslg.points.size(),
                                std::numeric_limits<double>::quiet_NaN());
  } else {
    domain = cut_domain(arrange(grid, outline, options), options);
  }
  name_entities(domain.pslg.entities);
  return domain;
}

}  // namespace lepp
