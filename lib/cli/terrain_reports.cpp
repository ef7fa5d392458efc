#include "terrain_reports.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lepp/geometry/text.hpp"
#include "lepp/terrain/small_angles.hpp"

namespace lepp::cli {

namespace {

// Means and root mean squares of two parts together.
double joined_mean(double a, std::size_t n, double b, std::size_t m) {
  const auto all = static_cast<double>(n + m);
  return all > 0 ? (a * static_cast<double>(n) + b * static_cast<double>(m)) / all : 0;
}

void add_to(LargestError& e, const LargestError& p) {
  if (p.max > e.max) e = p;
}

void add_to(TerrainError& e, const TerrainError& p) {
  const double mean_square = joined_mean(e.rms * e.rms, e.samples, p.rms * p.rms, p.samples);
  if (p.max > e.max || e.samples == 0) {
    e.max = p.max;
    e.column = p.column;
    e.row = p.row;
  }
  e.highest = std::max(e.highest, p.highest);
  e.lowest = std::min(e.lowest, p.lowest);
  e.rms = std::sqrt(mean_square);
  e.samples += p.samples;
  e.lost += p.lost;
  e.covered += p.covered;
  add_to(e.on_hard_lines, p.on_hard_lines);
  add_to(e.elsewhere, p.elsewhere);
  e.samples_on_hard_lines += p.samples_on_hard_lines;
}

void add_to(TerrainFigures& whole, const TerrainFigures& part) {
  if (part.error.max > whole.error.max || whole.error.samples == 0) whole.error_at = part.error_at;
  add_to(whole.error, part.error);
  if (part.unfitted) {
    if (!whole.unfitted) whole.unfitted.emplace();
    add_to(*whole.unfitted, *part.unfitted);
  }
  const bool is_first = whole.triangles == 0;
  whole.min_angle_deg =
      is_first ? part.min_angle_deg : std::min(whole.min_angle_deg, part.min_angle_deg);
  for (std::size_t i = 0; i < whole.below_bound.size(); ++i) {
    whole.below_bound[i] += part.below_bound[i];
  }
  whole.vertices += part.vertices;
  whole.triangles += part.triangles;
}

void add_to(TerrainSeconds& whole, const TerrainSeconds& part) {
  whole.read += part.read;
  whole.domain += part.domain;
  whole.simplify += part.simplify;
  whole.nonobtuse += part.nonobtuse;
  whole.fit += part.fit;
  whole.measure += part.measure;
  whole.check += part.check;
  whole.write += part.write;
}

void add_to(TerrainInSpace& whole, const TerrainInSpace& part) {
  whole.plan_angle_deg = part.plan_angle_deg;
  whole.tame += part.tame;
  whole.untame += part.untame;
  whole.kept_edges.insert(whole.kept_edges.end(), part.kept_edges.begin(), part.kept_edges.end());
}

// To two decimals: what is below a bound stays so.
double rounded_down(double angle_deg) { return std::floor(100 * angle_deg) / 100; }

std::size_t not_excused(const ReasonCounts& counts) {
  std::size_t sum = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (!is_excused(static_cast<Reason>(i))) sum += counts[i];
  }
  return sum;
}

}  // namespace

void add_to(TerrainReport& whole, const TerrainReport& part) {
  const bool is_first = whole.whole.triangles == 0;
  const auto smaller = [&](double a, double b) { return is_first ? b : std::min(a, b); };
  whole.max_angle_deg_found = std::max(whole.max_angle_deg_found, part.max_angle_deg_found);
  whole.mean_min_angle_deg = joined_mean(whole.mean_min_angle_deg, whole.whole.triangles,
                                         part.mean_min_angle_deg, part.whole.triangles);
  whole.in_space.min_angle_deg = smaller(whole.in_space.min_angle_deg, part.in_space.min_angle_deg);
  whole.in_space.mean_min_angle_deg =
      joined_mean(whole.in_space.mean_min_angle_deg, whole.whole.triangles,
                  part.in_space.mean_min_angle_deg, part.whole.triangles);
  add_to(whole.in_space, part.in_space);
  for (std::size_t i = 0; i < whole.smallest_angles.size(); ++i) {
    whole.smallest_angles[i] += part.smallest_angles[i];
  }
  whole.lowest = smaller(whole.lowest, part.lowest);
  whole.highest = is_first ? part.highest : std::max(whole.highest, part.highest);
  whole.obtuse_constrained += part.obtuse_constrained;
  whole.goal_reached = (is_first || whole.goal_reached) && part.goal_reached;
  whole.valid = whole.valid && part.valid;
  if (part.error_kept) whole.error_kept = whole.error_kept.value_or(true) && *part.error_kept;
  whole.samples += part.samples;
  add_to(whole.whole, part.whole);
  if (is_first) whole.levels.resize(part.levels.size());
  for (std::size_t i = 0; i < whole.levels.size(); ++i) add_to(whole.levels[i], part.levels[i]);
  add_to(whole.seconds, part.seconds);
  for (const std::string& w : part.warnings) {
    if (std::ranges::find(whole.warnings, w) == whole.warnings.end()) whole.warnings.push_back(w);
  }
  whole.violations.insert(whole.violations.end(), part.violations.begin(), part.violations.end());
}

void describe(const HeightGrid& grid, TerrainReport& report) {
  report.columns = grid.columns;
  report.rows = grid.rows;
  report.valid = true;
  const auto [low, high, count] = grid.heights.range();
  report.samples = count;
  if (count == 0) return;
  report.lowest = low;
  report.highest = high;
}

void describe(const TerrainCommand& command, const TerrainJob& job, TerrainReport& report) {
  describe(command, report);
  if (!command.max_error.empty()) report.max_error = job.simplify.max_error;
  report.border_error = job.border_error;
}

void describe(const TerrainCommand& command, TerrainReport& report) {
  report.by = command.by == SimplifyBy::lepp ? "lepp" : "greedy";
  report.metric = command.metric == TerrainMetric::planar ? "planar" : "surface";
  report.max_vertices = command.max_vertices;
  if (command.by == SimplifyBy::lepp) {
    report.min_angle_deg = command.min_angle_deg.value_or(SimplifyOptions().min_angle_deg);
  }
  report.window = command.grid_window();
  const TileCounts tiles = command.tile_counts();
  if (command.has_tiles()) report.tiling = {tiles.rows, tiles.columns};
}

void warn_of_cell(const TerrainCommand& command, const HeightGrid& whole,
                  std::vector<std::string>& warnings) {
  if (command.cell.size() != 2 || !whole.georeferenced) return;
  const double in_file = std::abs(whole.step_y) / whole.step_x;
  const double given = command.cell[1] / command.cell[0];
  if (std::abs(given - in_file) <= 1e-6 * in_file) return;
  warnings.push_back("lengths and angles are those of cells of " + lepp::to_text(command.cell[0]) +
                     " x " + lepp::to_text(command.cell[1]) +
                     ", as --cell says; coordinates stay those of the file, where cells are " +
                     lepp::to_text(whole.step_x) + " x " + lepp::to_text(std::abs(whole.step_y)) +
                     " and angles are others");
}

void warn_of_small_angles(TerrainReport& report) {
  const bool in_plan = report.metric != "surface";
  const double bound = in_plan ? report.min_angle_deg.value_or(0) : report.in_space.plan_angle_deg;
  for (std::size_t i = 0; i < report.levels.size(); ++i) {
    const TerrainFigures& level = report.levels[i];
    const std::size_t count = not_excused(level.below_bound);
    if (count == 0) continue;
    const bool no_room = level.below_bound[static_cast<std::size_t>(Reason::budget)] > 0;
    report.warnings.push_back(
        "level " + std::to_string(i + 1) + ": " + std::to_string(count) +
        (count == 1 ? " triangle is below " : " triangles are below ") + lepp::to_text(bound) +
        " degrees, the smallest angle is " + lepp::to_text(rounded_down(level.min_angle_deg)) +
        (no_room ? ": " + std::to_string(level.vertices) + " vertices leave no room"
                 : ", which the input does not ask for"));
  }
}

}  // namespace lepp::cli
