#include "lepp/terrain/world_tin.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/text.hpp"

namespace lepp {

namespace {

std::string title_of(const std::string& source) {
  std::string name = source.substr(source.find_last_of('/') + 1);
  for (char& c : name) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return name.empty() ? "terrain" : name;
}

constexpr double most_rounding = 1e-4;  // of a cell

// From the first sample's coordinate on, `count` of them, `step` apart.
double rounding_along(double first, double step, std::uint32_t count) {
  const double last = first + (count - 1.0) * step;
  return 0x1p-53 * std::max(std::abs(first), std::abs(last)) / std::abs(step);
}

InputError too_coarse(const HeightGrid& grid, const std::string& problem) {
  return {grid.source, problem,
          "count coordinates from a place nearby: " + advice_to_count_from_nearby(grid)};
}

}  // namespace

double world_rounding(const HeightGrid& grid) {
  return std::max(rounding_along(grid.origin.x, grid.step_x, grid.columns),
                  rounding_along(grid.origin.y, grid.step_y, grid.rows));
}

std::string advice_to_count_from_nearby(const HeightGrid& grid) {
  const double south = grid.origin.y + std::min(0.0, (grid.rows - 1.0) * grid.step_y);
  return "--origin " + to_decimal_text(std::floor(grid.origin.x)) + ' ' +
         to_decimal_text(std::floor(south));
}

void check_world_rounding(const HeightGrid& grid) {
  const double rounding = world_rounding(grid);
  if (rounding <= most_rounding) return;
  throw too_coarse(grid, "has coordinates around " + to_text(grid.origin) +
                             ", so large that doubles round them by " + to_text(rounding) +
                             " of its small cells");
}

InputError rounding_error(const HeightGrid& grid) {
  return too_coarse(grid, "gets triangles that lose their area where world coordinates around " +
                              to_text(grid.origin) + " are rounded");
}

bool is_counterclockwise(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const auto [a, b, c] = mesh.corners(TriangleId(i));
    if (!(orient2d(a, b, c) > 0)) return false;
  }
  return true;
}

void count_from(Point origin, HeightGrid& grid) {
  grid.origin = grid.origin - origin;
  grid.crs.clear();
}

WorldTin to_world(Tin tin, const HeightGrid& grid) {
  const bool was_valid = is_counterclockwise(tin.mesh);
  for (std::size_t i = 0; i < tin.mesh.vertex_count(); ++i) {
    const VertexId v(i);
    tin.mesh.move_vertex(v, grid.to_world(tin.mesh.point(v)));
  }
  if (was_valid && !is_counterclockwise(tin.mesh)) throw rounding_error(grid);
  return {std::move(tin.mesh), std::move(tin.heights), grid.crs, grid.degrees,
          title_of(grid.source)};
}

}  // namespace lepp
