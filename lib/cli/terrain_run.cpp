#include "terrain_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <utility>

#include "interrupt.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/terrain/fit_heights.hpp"
#include "lepp/terrain/hard_lines.hpp"
#include "lepp/terrain/nonobtuse_tin.hpp"
#include "lepp/terrain/samples_inside.hpp"
#include "lepp/terrain/surface_simplify.hpp"
#include "lepp/terrain/validate_surface.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/validate.hpp"
#include "lepp/voronoi/admissible.hpp"

namespace lepp::cli {

namespace {

// Runs `work` and returns how many seconds it took.
template <class Work>
double timed(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Tin shifted(Tin tin, const Point shift) {
  if (shift == Point{0, 0}) return tin;
  for (std::size_t i = 0; i < tin.mesh.vertex_count(); ++i) {
    tin.mesh.move_vertex(VertexId(i), tin.mesh.point(VertexId(i)) + shift);
  }
  return tin;
}

class Run {
 public:
  Run(const HeightGrid& grid, const GridPlace& place, const TerrainJob& job)
      : grid_(grid), place_(place), job_(job), rounding_(interpolation_rounding(grid)) {}

  MadeTerrain operator()() {
    describe(grid_, made_.report);
    check_world_rounding(place_.whole);
    report().seconds.domain = timed([&] {
      domain_ = terrain_domain(grid_, job_.domain);
      if (job_.border_error) {
        fix_borders(grid_, *job_.border_error, domain_, job_.border_corners);
      }
    });
    if (!job_.domain.clip.empty()) inside_ = samples_inside(grid_, domain_);
    report().warnings = domain_.warnings;
    warn_of_nodata();
    report().seconds.simplify = timed([&] { simplify_grid(); });
    if (job_.nonobtuse && !interrupted()) {
      report().seconds.nonobtuse = timed([&] { make_admissible(); });
    }
    if (job_.fit_heights) report().seconds.fit = timed([&] { fit_all(); });
    for (MadeTin& level : made_.coarser) finish(level);
    finish(made_.finest);
    judge_finest();
    return std::move(made_);
  }

 private:
  TerrainReport& report() { return made_.report; }

  // Where no heights are, a value of no data is that the file does not declare.
  void warn_of_nodata() {
    constexpr double no_height = 1e30;
    for (const double height : {report_lowest(), report_highest()}) {
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
      made_.coarser.emplace_back().tin = tin;
    };
    made_.finest.tin = simplify(grid_, domain_, options, simplified_);
    if (job_.border_error) excuse_borders();
  }

  // By the surface metric the sphere criterion holds but at the edges listed.
  void judge_in_space() {
    const MadeTin& finest = made_.finest;
    SurfaceReport& surface = simplified_.surface;
    note_angles(grid_, finest.tin, job_.simplify.min_angle_deg, surface);
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

  void make_admissible() {
    Progress progress;
    NonobtuseTinOptions options;
    options.max_error = job_.simplify.max_error;
    options.keep_error = job_.claims_error;
    options.min_angle_deg = job_.simplify.min_angle_deg;
    options.progress = [&](std::size_t vertices) { return progress(vertices); };
    NonobtuseTin made = make_nonobtuse(grid_, std::move(made_.finest.tin), options);
    made_.finest.tin = std::move(made.tin);
    in_world_ = std::move(made.in_world);
    judged_in_world_ = made.judged_in_world;
    simplified_.unfinished = std::move(made.unfinished);
    simplified_.goal_reached = made.goal_reached;
    advise_on_rounding();
    if (judged_in_world_) return;
    report().warnings.push_back(
        "the file's coordinates have not the proportions of the cells, so the mesh is admissible "
        "after scaling them, not in the file");
  }

  // A level may come as far off as it was, the finest as far as was asked for.
  void fit_all() {
    for (MadeTin& level : made_.coarser) fit(level, 0);
    fit(made_.finest, job_.claims_error ? job_.simplify.max_error : 0);
  }

  TerrainError measured(const Tin& tin) const {
    return measure_error(grid_, tin, inside_ ? &*inside_ : nullptr);
  }

  void fit(MadeTin& made, double max_error) {
    made.figures.unfitted = measured(made.tin);
    FitOptions options;
    options.max_error = std::max(max_error, made.figures.unfitted->elsewhere.max);
    options.is_fixed = fixed_vertices(grid_, domain_, made.tin);
    options.go_on = [] { return !interrupted(); };
    fit_heights(grid_, made.tin, options);
  }

  // Between lines that meet at small angles, triangles may be as small as rounding is.
  void advise_on_rounding() {
    constexpr double noticeable = 1e-8;  // of a cell
    const bool is_rounded = judged_in_world_ && world_rounding(grid_) > noticeable;
    const auto at_floor = [](const Unfinished& u) { return u.reason == Reason::size_floor; };
    if (!is_rounded || std::ranges::none_of(simplified_.unfinished, at_floor)) return;
    report().warnings.push_back(
        "coordinates are so large that rounding spoils the smallest triangles; counting from a "
        "place nearby may help: " +
        advice_to_count_from_nearby(grid_));
  }

  // Beside borders that must not be cut, the angle bound is out of reach of any method.
  void excuse_borders() {
    const Mesh& mesh = made_.finest.tin.mesh;
    const NearBorder is_near(grid_, domain_);
    for (Unfinished& u : simplified_.unfinished) {
      if (u.reason != Reason::size_floor) continue;
      if (std::ranges::any_of(mesh.corners(u.triangle), is_near)) u.reason = Reason::kept_border;
    }
    const bool error_kept = is_kept(simplified_.error, job_.simplify.max_error);
    simplified_.goal_reached = error_kept && angles_reached();
  }

  // What is claimed of every level: an error that was measured anew, and a valid mesh, also where
  // the world's coordinates are rounded.
  void finish(MadeTin& made) {
    TerrainFigures& figures = made.figures;
    const bool is_finest = &made == &made_.finest;
    figures.vertices = made.tin.mesh.vertex_count();
    figures.triangles = made.tin.mesh.triangle_count();
    report().seconds.measure += timed([&] { figures.error = measured(made.tin); });
    figures.error.column += place_.column;
    figures.error.row += place_.row;
    const std::uint32_t row = figures.error.row;
    figures.error_at = place_.whole.to_world(place_.whole.sample(
        figures.error.column, place_.whole.north_first() ? place_.whole.rows - 1 - row : row));
    made.world = to_world(shifted(made.tin, shift_of(grid_, place_)), place_.whole);
    if (is_finest && in_world_) made.world.mesh = std::move(*in_world_);
    const bool world_counts = is_finest && job_.nonobtuse && judged_in_world_;
    MeshClaims claims = is_finest ? claims_of_finest() : MeshClaims();
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

  MeshClaims claims_of_finest() const {
    MeshClaims claims;
    if (!bounds_angles()) return claims;
    claims.min_angle_deg = job_.simplify.min_angle_deg;
    claims.nonobtuse = job_.nonobtuse;
    claims.unfinished = simplified_.unfinished;
    return claims;
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

  bool angles_reached() const {
    return std::ranges::all_of(simplified_.unfinished, [](const Unfinished& u) {
      return is_forced_by_input(u.reason) || u.reason == Reason::kept_border;
    });
  }

  void judge_finest() {
    const MadeTin& finest = made_.finest;
    TerrainReport& r = report();
    r.whole = finest.figures;
    for (const MadeTin& level : made_.coarser) r.levels.push_back(level.figures);
    r.seconds.measure += timed([&] {
      const bool world_counts = job_.nonobtuse && judged_in_world_;
      const Mesh& judged = world_counts ? finest.world.mesh : finest.tin.mesh;
      const Quality quality = measure(judged);
      r.min_angle_deg_found = quality.min_angle_deg;
      r.max_angle_deg_found = quality.max_angle_deg;
      r.mean_min_angle_deg = quality.mean_min_angle_deg;
      r.obtuse_constrained = quality.obtuse_constrained.exact;
      r.smallest_angles = angle_histogram(judged);
    });
    r.below_bound = count_reasons(simplified_.unfinished);
    judge_in_space();
    // Asked for a number of vertices alone, a run may be as far off as it is.
    const bool is_good = job_.claims_error ? simplified_.goal_reached : angles_reached();
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
    const std::vector<HardSample> samples = samples_on_hard_lines(grid_, made_.finest.tin);
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

  bool is_kept(const TerrainError& error, double asked) const {
    const double in_world =
        job_.nonobtuse ? rounding_in_world * (report_highest() - report_lowest()) : 0;
    return error.elsewhere.max <= kept_error(asked, rounding_) + in_world;
  }
  double report_lowest() const { return made_.report.lowest; }
  double report_highest() const { return made_.report.highest; }

  bool is_count_kept() {
    const std::size_t most = job_.simplify.max_vertices;
    if (report().whole.vertices <= most) return true;
    report().warnings.push_back("the outline and lines alone have " +
                                std::to_string(simplified_.first_prefix) +
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
  TerrainDomain domain_;
  std::optional<SampleSet> inside_;  // clip polygons
  SimplifyReport simplified_;
  std::optional<Mesh> in_world_;  // of --nonobtuse: as it was refined there
  bool judged_in_world_ = true;
  MadeTerrain made_;
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

void describe(const HeightGrid& grid, TerrainReport& report) {
  report.columns = grid.columns;
  report.rows = grid.rows;
  report.valid = true;
  grid.heights.visit([&]<class Height>(std::span<const Height> heights) {
    Height low = INFINITY, high = -INFINITY;
    for (const Height h : heights) {
      if (std::isnan(h)) continue;
      ++report.samples;
      low = std::min(low, h);
      high = std::max(high, h);
    }
    if (report.samples == 0) return;
    report.lowest = low;
    report.highest = high;
  });
}

}  // namespace lepp::cli
