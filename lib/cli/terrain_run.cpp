#include "terrain_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "interrupt.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/terrain/nonobtuse_tin.hpp"
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

// From the grid space of a window to that of the whole grid.
Tin shifted(Tin tin, const HeightGrid& window, const GridPlace& place) {
  const std::uint32_t line =
      window.north_first() ? place.whole.rows - place.row - window.rows : place.row;
  const Point shift{double(place.column), double(line) * window.aspect()};
  if (shift == Point{0, 0}) return tin;
  for (std::size_t i = 0; i < tin.mesh.vertex_count(); ++i) {
    tin.mesh.move_vertex(VertexId(i), tin.mesh.point(VertexId(i)) + shift);
  }
  return tin;
}

class Run {
 public:
  Run(const HeightGrid& grid, const GridPlace& place, const TerrainJob& job)
      : grid_(grid), place_(place), job_(job) {}

  MadeTerrain operator()() {
    describe(grid_, made_.report);
    check_world_rounding(place_.whole);
    report().seconds.domain = timed([&] {
      domain_ = terrain_domain(grid_, job_.domain);
      if (job_.border_error) {
        fix_borders(grid_, *job_.border_error, domain_, job_.border_corners);
      }
    });
    report().warnings = domain_.warnings;
    report().seconds.simplify = timed([&] { simplify_grid(); });
    if (job_.nonobtuse && !interrupted()) {
      report().seconds.nonobtuse = timed([&] { make_admissible(); });
    }
    for (MadeTin& level : made_.coarser) finish(level);
    finish(made_.finest);
    judge_finest();
    return std::move(made_);
  }

 private:
  TerrainReport& report() { return made_.report; }

  // Heights are kept as floats. Where the file has more digits, what that takes away counts, unless
  // it is a millionth of their range or less.
  double rounding() const {
    constexpr double negligible = 1e-6;
    const double range = report_highest() - report_lowest();
    return grid_.rounding > negligible * range ? grid_.rounding : 0;
  }

  void allow_for_rounding(SimplifyOptions& options) {
    const double rounding = this->rounding();
    if (rounding == 0) return;
    report().warnings.push_back("heights are kept as floats, which changes them by up to " +
                                lepp::to_text(rounding) + "; the error kept allows for that");
    if (!job_.claims_error) return;
    if (options.max_error < rounding) {
      throw InputError(grid_.source,
                       "has heights of more digits than floats hold: they would change by up to " +
                           lepp::to_text(rounding) + ", more than the error asked for",
                       "ask for a larger error, or subtract a common height from all");
    }
    options.max_error -= rounding;
    for (double& error : options.level_errors) error -= rounding;
  }

  void simplify_grid() {
    Progress progress;
    SimplifyOptions options = job_.simplify;
    allow_for_rounding(options);
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
    options.max_error = job_.simplify.max_error - rounding();
    options.keep_error = job_.claims_error;
    options.min_angle_deg = job_.simplify.min_angle_deg;
    options.progress = [&](std::size_t vertices) { return progress(vertices); };
    NonobtuseTin made = make_nonobtuse(grid_, domain_, std::move(made_.finest.tin), options);
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
    report().seconds.measure += timed([&] { figures.error = measure_error(grid_, made.tin); });
    figures.error.column += place_.column;
    figures.error.row += place_.row;
    const std::uint32_t row = figures.error.row;
    figures.error_at = place_.whole.to_world(place_.whole.sample(
        figures.error.column, place_.whole.north_first() ? place_.whole.rows - 1 - row : row));
    made.world = to_world(shifted(made.tin, grid_, place_), place_.whole);
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
    check_coverage(r.whole.error);
  }

  // Two ways of interpolating differ by a trifle.
  bool is_kept(const TerrainError& error, double asked) const {
    const double largest = std::max(std::abs(report_lowest()), std::abs(report_highest()));
    const double in_world =
        job_.nonobtuse ? rounding_in_world * (report_highest() - report_lowest()) : 0;
    return error.max <= asked * (1 + 1e-9) + 1e-12 * largest + in_world;
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
    if (error.lost == 0) return;
    if (job_.domain.clip.empty()) break_rule("samples with data are in no triangle");
  }

  const HeightGrid& grid_;
  const GridPlace& place_;
  const TerrainJob& job_;
  TerrainDomain domain_;
  SimplifyReport simplified_;
  std::optional<Mesh> in_world_;  // of --nonobtuse: as it was refined there
  bool judged_in_world_ = true;
  MadeTerrain made_;
};

// Means and root mean squares of two parts together.
double joined_mean(double a, std::size_t n, double b, std::size_t m) {
  const auto all = static_cast<double>(n + m);
  return all > 0 ? (a * static_cast<double>(n) + b * static_cast<double>(m)) / all : 0;
}

void add_to(TerrainFigures& whole, const TerrainFigures& part) {
  TerrainError& e = whole.error;
  const TerrainError& p = part.error;
  const double mean_square = joined_mean(e.rms * e.rms, e.samples, p.rms * p.rms, p.samples);
  if (p.max > e.max || e.samples == 0) {
    e.max = p.max;
    e.column = p.column;
    e.row = p.row;
    whole.error_at = part.error_at;
  }
  e.highest = std::max(e.highest, p.highest);
  e.lowest = std::min(e.lowest, p.lowest);
  e.rms = std::sqrt(mean_square);
  e.samples += p.samples;
  e.lost += p.lost;
  e.covered += p.covered;
  whole.vertices += part.vertices;
  whole.triangles += part.triangles;
}

void add_to(TerrainSeconds& whole, const TerrainSeconds& part) {
  whole.read += part.read;
  whole.domain += part.domain;
  whole.simplify += part.simplify;
  whole.nonobtuse += part.nonobtuse;
  whole.measure += part.measure;
  whole.check += part.check;
  whole.write += part.write;
}

}  // namespace

MadeTerrain make_terrain(const HeightGrid& grid, const GridPlace& place, const TerrainJob& job) {
  return Run(grid, place, job)();
}

void add_to(TerrainInSpace& whole, const TerrainInSpace& part) {
  whole.plan_angle_deg = part.plan_angle_deg;
  whole.tame += part.tame;
  whole.untame += part.untame;
  whole.kept_edges.insert(whole.kept_edges.end(), part.kept_edges.begin(), part.kept_edges.end());
}

void add_to(TerrainReport& whole, const TerrainReport& part) {
  const bool is_first = whole.whole.triangles == 0;
  const auto smaller = [&](double a, double b) { return is_first ? b : std::min(a, b); };
  whole.min_angle_deg_found = smaller(whole.min_angle_deg_found, part.min_angle_deg_found);
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
  for (std::size_t i = 0; i < whole.below_bound.size(); ++i) {
    whole.below_bound[i] += part.below_bound[i];
  }
  whole.lowest = smaller(whole.lowest, part.lowest);
  whole.highest = is_first ? part.highest : std::max(whole.highest, part.highest);
  whole.obtuse_constrained += part.obtuse_constrained;
  whole.goal_reached = (is_first || whole.goal_reached) && part.goal_reached;
  whole.valid = whole.valid && part.valid;
  if (part.error_kept) whole.error_kept = whole.error_kept.value_or(true) && *part.error_kept;
  add_to(whole.whole, part.whole);
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
  float low = INFINITY, high = -INFINITY;
  for (const float h : grid.heights) {
    if (std::isnan(h)) continue;
    ++report.samples;
    low = std::min(low, h);
    high = std::max(high, h);
  }
  if (report.samples == 0) return;
  report.lowest = low;
  report.highest = high;
}

}  // namespace lepp::cli
