#include "terrain_judge.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "interrupt.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/terrain/hard_lines.hpp"
#include "lepp/terrain/nonobtuse_tin.hpp"
#include "lepp/terrain/small_angles.hpp"
#include "lepp/terrain/surface_simplify.hpp"
#include "lepp/terrain/validate_surface.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/validate.hpp"
#include "lepp/voronoi/admissible.hpp"
#include "stopwatch.hpp"

namespace lepp::cli {

namespace {

Tin shifted(Tin tin, const Point shift) {
  if (shift == Point{0, 0}) return tin;
  for (std::size_t i = 0; i < tin.mesh.vertex_count(); ++i) {
    tin.mesh.move_vertex(VertexId(i), tin.mesh.point(VertexId(i)) + shift);
  }
  return tin;
}

class Judge {
 public:
  Judge(const HeightGrid& grid, const GridPlace& place, const TerrainJob& job, TerrainWork work)
      : grid_(grid),
        place_(place),
        job_(job),
        rounding_(interpolation_rounding(grid)),
        work_(std::move(work)) {}

  MadeTerrain operator()() {
    if (job_.border_error) excuse_borders();
    for (std::size_t i = 0; i < work_.made.coarser.size(); ++i) {
      finish(work_.made.coarser[i], work_.simplified.levels[i].unfinished);
    }
    finish(work_.made.finest, work_.simplified.unfinished);
    judge_finest();
    return std::move(work_.made);
  }

 private:
  TerrainReport& report() { return work_.made.report; }

  // Then simplify() has measured the very TIN, from nothing but it and the grid.
  bool is_as_simplified() const { return !job_.nonobtuse && !job_.fit_heights; }

  // Beside borders that must not be cut, the angle bound is out of reach of any method.
  void excuse_borders() {
    const NearBorder is_near(grid_, work_.domain);
    const auto excuse = [&](const Mesh& mesh, std::vector<Unfinished>& unfinished) {
      for (Unfinished& u : unfinished) {
        if (u.reason != Reason::size_floor) continue;
        if (std::ranges::any_of(mesh.corners(u.triangle), is_near)) u.reason = Reason::kept_border;
      }
    };
    for (std::size_t i = 0; i < work_.made.coarser.size(); ++i) {
      excuse(work_.made.coarser[i].tin.mesh, work_.simplified.levels[i].unfinished);
    }
    excuse(work_.made.finest.tin.mesh, work_.simplified.unfinished);
    const bool error_kept = is_kept(work_.simplified.error, job_.simplify.max_error);
    work_.simplified.goal_reached = error_kept && are_excused(work_.simplified.unfinished);
  }

  // What is claimed of every level: an error that was measured anew, and a valid mesh, also where
  // the world's coordinates are rounded, with no small angles but those listed.
  void finish(MadeTin& made, const std::vector<Unfinished>& small_angles) {
    TerrainFigures& figures = made.figures;
    const bool is_finest = &made == &work_.made.finest;
    figures.vertices = made.tin.mesh.vertex_count();
    figures.triangles = made.tin.mesh.triangle_count();
    report().seconds.measure += timed([&] {
      const bool is_known = is_finest && is_as_simplified() && !work_.inside;
      figures.error = is_known ? work_.simplified.error : work_.measured(grid_, made.tin);
    });
    figures.error.column += place_.column;
    figures.error.row += place_.row;
    const std::uint32_t row = figures.error.row;
    figures.error_at = place_.whole.to_world(place_.whole.sample(
        figures.error.column, place_.whole.north_first() ? place_.whole.rows - 1 - row : row));
    made.world = to_world(shifted(made.tin, shift_of(grid_, place_)), place_.whole);
    if (is_finest && work_.in_world) made.world.mesh = std::move(*work_.in_world);
    const bool world_counts = is_finest && job_.nonobtuse && work_.judged_in_world;
    figures.below_bound = count_reasons(small_angles);
    report().seconds.measure += timed([&] {
      const Mesh& judged = world_counts ? made.world.mesh : made.tin.mesh;
      const Quality quality = measure(judged);
      figures.min_angle_deg = quality.min_angle_deg;
      if (is_finest) note_angles_of(judged, quality);
    });
    MeshClaims claims = claims_of(small_angles);
    claims.delaunay = job_.simplify.metric == TerrainMetric::planar;
    MeshClaims none;
    none.delaunay = false;
    report().seconds.check += timed([&] {
      note(validate(made.tin.mesh, world_counts ? none : claims));
      note(validate(made.world.mesh, world_counts ? claims : none));
      if (!is_finest || !job_.nonobtuse) return;
      const Certificate certificate = certify(world_counts ? made.world.mesh : made.tin.mesh);
      report().admissible = certificate.admissible;
    });
  }

  MeshClaims claims_of(const std::vector<Unfinished>& small_angles) const {
    MeshClaims claims;
    if (!bounds_angles()) return claims;
    claims.min_angle_deg = job_.simplify.min_angle_deg;
    claims.nonobtuse = job_.nonobtuse;  // then there are no coarser levels
    claims.unfinished = small_angles;
    return claims;
  }

  void note_angles_of(const Mesh& finest, const Quality& quality) {
    report().max_angle_deg_found = quality.max_angle_deg;
    report().mean_min_angle_deg = quality.mean_min_angle_deg;
    report().obtuse_constrained = quality.obtuse_constrained.exact;
    report().smallest_angles = angle_histogram(finest);
  }

  void note(const MeshReport& checked) {
    report().valid = report().valid && checked.valid();
    report().violations.insert(report().violations.end(), checked.violations.begin(),
                               checked.violations.end());
  }

  bool bounds_angles() const {
    return job_.simplify.by == SimplifyBy::lepp && job_.simplify.min_angle_deg > 0 &&
           job_.simplify.metric == TerrainMetric::planar;
  }

  void judge_finest() {
    TerrainReport& r = report();
    r.whole = work_.made.finest.figures;
    for (const MadeTin& level : work_.made.coarser) r.levels.push_back(level.figures);
    if (job_.lists_prefixes) {
      r.prefixes =
          PrefixErrors{work_.simplified.first_prefix, std::move(work_.simplified.error_of_prefix)};
    }
    judge_in_space();
    warn_of_counts();
    // Asked for a number of vertices alone, a run may be as far off as it is.
    const bool is_good = job_.claims_error ? work_.simplified.goal_reached
                                           : are_excused(work_.simplified.unfinished);
    r.goal_reached = is_count_kept() && is_good && !interrupted() && r.admissible.value_or(true);
    if (job_.claims_error) r.error_kept = is_kept(r.whole.error, job_.simplify.max_error);
    if (job_.claims_error && r.goal_reached && !*r.error_kept) break_rule("the error is not kept");
    if (job_.claims_error) warn_of_hard_lines();
    check_coverage(r.whole.error);
    for (const TerrainFigures& level : r.levels) check_coverage(level.error);
  }

  // What they are off by was asked for, but perhaps not meant.
  void warn_of_hard_lines() {
    const LargestError& largest = report().whole.error.on_hard_lines;
    const double most = kept_error(job_.simplify.max_error, rounding_);
    if (largest.max <= most) return;
    const std::vector<HardSample> samples = samples_on_hard_lines(grid_, work_.made.finest.tin);
    const auto count = std::ranges::count_if(samples, [&](const HardSample& s) {
      return std::abs(grid_.height(s.column, s.row) - s.height) > most;
    });
    report().warnings.push_back(
        std::to_string(count) + " of " +
        std::to_string(report().whole.error.samples_on_hard_lines) +
        " samples on breaklines with heights of their own are off by more than the error asked "
        "for, by up to " +
        lepp::to_text(largest.max) + "; --soft-breaklines takes the heights of the grid");
  }

  // By the surface metric the sphere criterion holds but at the edges listed.
  void judge_in_space() {
    const MadeTin& finest = work_.made.finest;
    SurfaceReport& surface = work_.simplified.surface;
    if (!is_as_simplified()) note_angles(grid_, finest.tin, job_.simplify.min_angle_deg, surface);
    TerrainInSpace& in_space = report().in_space;
    in_space.min_angle_deg = surface.min_angle_deg;
    in_space.mean_min_angle_deg = surface.mean_min_angle_deg;
    if (job_.simplify.metric == TerrainMetric::planar) return;
    in_space.plan_angle_deg = surface.plan_angle_deg;
    in_space.tame = surface.tame;
    in_space.untame = surface.untame;
    for (const auto& [edge, rule] : surface.violations) {
      const Mesh& world = finest.world.mesh;
      in_space.kept_edges.push_back(
          {world.point(world.origin(edge)), world.point(world.destination(edge)), rule});
    }
    report().seconds.check += timed([&] {
      note(validate_surface(grid_, finest.tin,
                            {surface.bound, surface.plan_angle_deg, surface.violations}));
    });
  }

  bool is_kept(const TerrainError& error, double asked) const {
    const double range = work_.made.report.highest - work_.made.report.lowest;
    const double in_world = job_.nonobtuse ? rounding_in_world * range : 0;
    return error.elsewhere.max <= kept_error(asked, rounding_) + in_world;
  }

  void warn_of_counts() {
    for (std::size_t i = 0; i < work_.made.coarser.size(); ++i) {
      const TerrainLevel& level = work_.simplified.levels[i];
      if (!level.most_vertices || level.vertices <= *level.most_vertices) continue;
      report().warnings.push_back("level " + std::to_string(i + 1) + ": the outline and lines " +
                                  "alone have " + std::to_string(work_.simplified.first_prefix) +
                                  " vertices, more than the " +
                                  std::to_string(*level.most_vertices) + " asked for");
    }
  }

  bool is_count_kept() {
    const std::size_t most = job_.simplify.max_vertices;
    if (report().whole.vertices <= most) return true;
    report().warnings.push_back("the outline and lines alone have " +
                                std::to_string(work_.simplified.first_prefix) +
                                " vertices, more than the " + std::to_string(most) +
                                " asked for; a larger --max-vertices is needed, or fewer lines");
    return false;
  }

  void break_rule(const std::string& what) {
    report().valid = false;
    report().violations.push_back({"E", what + ": " + lepp::to_text(report().whole.error.max) +
                                            " at " + lepp::to_text(report().whole.error_at)});
  }

  void check_coverage(const TerrainError& error) {
    if (error.covered > 0) break_rule("triangles cover samples without data");
    if (error.lost > 0) break_rule("samples with data are in no triangle");
  }

  const HeightGrid& grid_;
  const GridPlace& place_;
  const TerrainJob& job_;
  const double rounding_;
  TerrainWork work_;
};

}  // namespace

MadeTerrain judged(const HeightGrid& grid, const GridPlace& place, const TerrainJob& job,
                   TerrainWork work) {
  return Judge(grid, place, job, std::move(work))();
}

}  // namespace lepp::cli
