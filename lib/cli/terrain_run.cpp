#include "terrain_run.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "interrupt.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/terrain/fit_heights.hpp"
#include "lepp/terrain/nonobtuse_tin.hpp"
#include "stopwatch.hpp"
#include "terrain_judge.hpp"
#include "terrain_reports.hpp"

namespace lepp::cli {

namespace {

class Run {
 public:
  Run(const HeightGrid& grid, const GridPlace& place, const TerrainJob& job)
      : grid_(grid), place_(place), job_(job) {}

  MadeTerrain operator()() {
    describe(grid_, report());
    check_world_rounding(place_.whole);
    report().seconds.domain = timed([&] {
      work_.domain = terrain_domain(grid_, job_.domain);
      if (job_.border_error) {
        fix_borders(grid_, *job_.border_error, work_.domain, job_.border_corners);
      }
    });
    if (!job_.domain.clip.empty()) work_.inside = samples_inside(grid_, work_.domain);
    report().warnings = work_.domain.warnings;
    warn_of_nodata();
    report().seconds.simplify = timed([&] { simplify_grid(); });
    if (job_.nonobtuse && !interrupted()) {
      report().seconds.nonobtuse = timed([&] { make_admissible(); });
    }
    if (job_.fit_heights) report().seconds.fit = timed([&] { fit_all(); });
    return judged(grid_, place_, job_, std::move(work_));
  }

 private:
  TerrainReport& report() { return work_.made.report; }

  // Where no heights are, a value of no data is that the file does not declare.
  void warn_of_nodata() {
    constexpr double no_height = 1e30;
    for (const double height : {report().lowest, report().highest}) {
      if (std::abs(height) < no_height) continue;
      const std::string value = lepp::to_text(height);
      report().warnings.push_back("heights reach " + value +
                                  "; if that means no data, add --nodata " + value);
    }
  }

  void simplify_grid() {
    Progress progress;
    SimplifyOptions options = job_.simplify;
    options.progress = [&](std::size_t vertices) { return progress(vertices); };
    options.on_level = [&](const Tin& tin, const TerrainLevel&) {
      work_.made.coarser.emplace_back().tin = tin;
    };
    work_.made.finest.tin = simplify(grid_, work_.domain, options, work_.simplified);
  }

  void make_admissible() {
    Progress progress;
    NonobtuseTinOptions options;
    options.max_error = job_.simplify.max_error;
    options.keep_error = job_.claims_error;
    options.min_angle_deg = job_.simplify.min_angle_deg;
    options.progress = [&](std::size_t vertices) { return progress(vertices); };
    NonobtuseTin made = make_nonobtuse(grid_, std::move(work_.made.finest.tin), options);
    work_.made.finest.tin = std::move(made.tin);
    work_.in_world = std::move(made.in_world);
    work_.judged_in_world = made.judged_in_world;
    work_.simplified.unfinished = std::move(made.unfinished);
    work_.simplified.goal_reached = made.goal_reached;
    advise_on_rounding();
    if (work_.judged_in_world) return;
    report().warnings.push_back(
        "the file's coordinates have not the proportions of the cells, so the mesh is admissible "
        "after scaling them, not in the file");
  }

  // A level may come as far off as it was, the finest as far as was asked for.
  void fit_all() {
    for (MadeTin& level : work_.made.coarser) fit(level, 0);
    fit(work_.made.finest, job_.claims_error ? job_.simplify.max_error : 0);
  }

  void fit(MadeTin& made, double max_error) {
    made.figures.unfitted = work_.measured(grid_, made.tin);
    FitOptions options;
    options.max_error = std::max(max_error, made.figures.unfitted->elsewhere.max);
    options.is_fixed = fixed_vertices(grid_, work_.domain, made.tin);
    options.go_on = [] { return !interrupted(); };
    fit_heights(grid_, made.tin, options);
  }

  // Between lines that meet at small angles, triangles may be as small as rounding is.
  void advise_on_rounding() {
    constexpr double noticeable = 1e-8;  // of a cell
    const bool is_rounded = work_.judged_in_world && world_rounding(grid_) > noticeable;
    const auto at_floor = [](const Unfinished& u) { return u.reason == Reason::size_floor; };
    if (!is_rounded || std::ranges::none_of(work_.simplified.unfinished, at_floor)) return;
    report().warnings.push_back(
        "coordinates are so large that rounding spoils the smallest triangles; counting from a "
        "place nearby may help: " +
        advice_to_count_from_nearby(grid_));
  }

  const HeightGrid& grid_;
  const GridPlace& place_;
  const TerrainJob& job_;
  TerrainWork work_;
};

}  // namespace

Point shift_of(const HeightGrid& window, const GridPlace& place) {
  const std::uint32_t line =
      window.north_first() ? place.whole.rows - place.row - window.rows : place.row;
  return {double(place.column), double(line) * window.aspect()};
}

MadeTerrain make_terrain(const HeightGrid& grid, const GridPlace& place, const TerrainJob& job) {
  return Run(grid, place, job)();
}

}  // namespace lepp::cli
