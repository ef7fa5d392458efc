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

// From a sample on a side of the grid to the inside; 0, 0 from one that is on none.
Point inward(const HeightGrid& grid, LatticePoint at) {
  const auto along = [](std::uint32_t i, std::uint32_t count) {
    return i == 0 ? 1.0 : i + 1 == count ? -1.0 : 0.0;
  };
  return {along(at.column, grid.columns), along(at.line, grid.rows)};
}

// Counter-clockwise, around the sample, or with a corner there and nothing else on the side:
//
//      |  b          d, from the sample s to the inside; a and b are on the square
//      s --- d       that s would get elsewhere, or in the corner of the grid on
//      |  a          half of it
std::vector<Point> island_around(const HeightGrid& grid, LatticePoint at, bool stays_inside) {
  const double size = island_size(grid);
  const Point s = grid.sample(at.column, at.line);
  const Point d = stays_inside ? inward(grid, at) : Point{0, 0};
  const Point across{-d.y, d.x};
  if (d == Point{0, 0})
    return {s + Point{size, 0}, s + Point{0, size}, s - Point{size, 0}, s - Point{0, size}};
  const bool in_corner = d.x != 0 && d.y != 0;
  const double along = in_corner ? 0.375 * size : 0.5 * size;
  const double aside = in_corner ? 0.125 * size : 0.5 * size;
  return {s, s + along * d - aside * across, s + along * d + aside * across};
}

void add_islands(const HeightGrid& grid, const Outline& outline, bool stay_inside, Pslg& pslg) {
  for (const LatticePoint at : outline.islands) {
    const std::vector<Point> island = island_around(grid, at, stay_inside);
    const std::size_t first = pslg.points.size(), n = island.size();
    pslg.points.insert(pslg.points.end(), island.begin(), island.end());
    for (std::size_t k = 0; k < n; ++k)
      pslg.segments.push_back({VertexId(first + k), VertexId(first + (k + 1) % n), CurveId(0U)});
  }
}

// All segments are of curve 0.
Pslg pslg_of_outline(const HeightGrid& grid, bool islands_stay_inside) {
  const Outline outline = outline_of(grid);
  Pslg pslg;
  pslg.source = grid.source;
  pslg.entities.curves.emplace_back().tag = 1;
  for (const LatticePoint p : outline.corners) pslg.points.push_back(grid.sample(p.column, p.line));
  for (const auto& [a, b] : outline.edges)
    pslg.segments.push_back({VertexId(a), VertexId(b), CurveId(0U)});
  add_islands(grid, outline, islands_stay_inside, pslg);
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
  Pslg outline = pslg_of_outline(grid, options.islands_stay_inside);
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
