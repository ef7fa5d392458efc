#include "lepp/terrain/simplify.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/terrain/greedy.hpp"
#include "lepp/terrain/lepp_simplify.hpp"
#include "lepp/terrain/levels.hpp"
#include "lepp/terrain/small_angles.hpp"
#include "lepp/terrain/surface_simplify.hpp"
#include "lepp/terrain/terrain_mesh.hpp"

namespace lepp {

namespace {

constexpr double largest_min_angle = 34;

void check(bool good, const std::string& where, const std::string& problem,
           const std::string& remedy) {
  if (!good) throw InputError(where, problem, remedy);
}

void check_options(const SimplifyOptions& o) {
  const std::string where = "options of terrain simplification";
  check(o.max_error >= 0 && std::isfinite(o.max_error), where,
        "the largest error is negative or no number", "give one of 0 or more");
  check(o.min_angle_deg >= 0 && o.min_angle_deg <= largest_min_angle, where,
        "the smallest angle is not between 0 and 34 degrees", "give one that is");
  check(o.metric == TerrainMetric::planar || o.by == SimplifyBy::lepp, where,
        "greedy insertion knows the planar metric alone", "simplify by lepp, or in plan");
  check(std::ranges::is_sorted(o.level_errors, std::greater<>()) &&
            (o.level_errors.empty() || o.level_errors.back() >= o.max_error),
        where, "the errors of the levels do not descend to the largest error",
        "sort them, the largest first, all above the error of the whole");
  check(std::ranges::is_sorted(o.level_vertices) &&
            (o.level_vertices.empty() || o.level_vertices.back() <= o.max_vertices),
        where, "the vertex counts of the levels do not ascend to the largest number of vertices",
        "sort them, the smallest first, all below the number of the whole");
}

// The metric of the surface compares squares of lengths in plan and of heights in one sum.
void check_relief(const HeightGrid& grid) {
  constexpr double most_cells = 1e9;
  const auto [low, high, count] = grid.heights.range();
  const double cell = std::min(grid.cell_width, grid.cell_height);
  check(count == 0 || high - low <= most_cells * cell, grid.source,
        "its heights reach from " + to_text(low) + " to " + to_text(high) +
            ", more than a thousand million cells: the metric of the surface cannot compare them",
        "check the value that means no data and the size of cells, or simplify in plan");
}

}  // namespace

Tin simplify(const HeightGrid& grid, const TerrainDomain& domain, const SimplifyOptions& options,
             SimplifyReport& report) {
  check_options(options);
  if (options.metric == TerrainMetric::surface) check_relief(grid);
  report = {};
  TerrainMesh terrain(grid, domain);
  Levels levels(grid, options, report);
  report.first_prefix = terrain.mesh().vertex_count();
  if (options.by == SimplifyBy::greedy) {
    greedy(terrain, levels, report.error_of_prefix);
  } else if (options.metric == TerrainMetric::surface) {
    surface_simplify(terrain, levels, options, report);
  } else {
    report.unfinished = lepp_simplify(terrain, levels, options);
  }
  Tin tin = terrain.take();
  report.error = measure_error(grid, tin);
  if (!report.error_of_prefix.empty()) report.error_of_prefix.back() = report.error.max;
  report.levels.push_back({tin.mesh.vertex_count(), report.error.max, {}, report.unfinished});
  note_angles(grid, tin, options.min_angle_deg, report.surface);
  report.goal_reached = levels.is_kept(report.error.elsewhere.max) &&
                        tin.mesh.vertex_count() <= options.max_vertices &&
                        are_excused(report.unfinished);
  return tin;
}

}  // namespace lepp
