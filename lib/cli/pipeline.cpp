#include "pipeline.hpp"

#include <algorithm>
#include <cmath>
#include <thread>

#include "interrupt.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/geometry/two_threads.hpp"
#include "lepp/nonobtuse/nonobtuse.hpp"
#include "lepp/triangulation/boundary_meetings.hpp"
#include "lepp/triangulation/flip.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/triangulation/validate.hpp"
#include "lepp/voronoi/admissible.hpp"
#include "stopwatch.hpp"

namespace lepp::cli {

namespace {

class Pipeline {
 public:
  Pipeline(const Input& input, const MeshOptions& options) : input_(input), options_(options) {
    options_.refine.size = size_field(options.sizes, input);
  }

  Meshed run() {
    report_.warnings = input_.warnings;
    if (options_.sizes.grading && !options_.refine.size) {
      report_.warnings.push_back("--grading has no effect: there are no sizes of points");
    }
    triangulate();
    note_stage("triangulate", mesh_.vertex_count());
    report_.input_vertices = mesh_.vertex_count();
    if (asks_for_refinement()) {
      measure_stage();
      Progress progress;
      RefineOptions refine_options = options_.refine;
      refine_options.progress = [&](std::size_t vertices) { return progress(vertices); };
      report_.seconds.refine = timed([&] { raise_angles(refine_options); });
      note_stage("refine", report_.input_vertices);
    } else {
      refined_.goal_reached = true;
    }
    if (options_.method == Method::paper && options_.nonobtuse && !interrupted()) {
      measure_stage();
      const std::size_t before = mesh_.vertex_count();
      report_.seconds.nonobtuse = timed([&] { remove_obtuse_angles(); });
      note_stage("nonobtuse", before);
    }
    refuse_overlap();
    finish();
    return {std::move(mesh_), std::move(report_)};
  }

 private:
  bool asks_for_angles() const {
    return options_.refine.min_angle_deg > 0 || options_.nonobtuse ||
           options_.refine.max_angle_deg < 180;
  }
  bool asks_for_refinement() const {
    const auto has_limit = [](const SurfaceEntity& s) {
      return std::isfinite(s.max_area) || std::isfinite(s.max_edge);
    };
    return asks_for_angles() || std::isfinite(options_.refine.max_edge) ||
           std::isfinite(options_.refine.max_area) || options_.refine.size ||
           std::ranges::any_of(mesh_.entities().surfaces, has_limit);
  }
  bool is_improvement() const { return input_.triangles && !options_.remesh; }

  void triangulate() {
    const EndsAtOnce nothing_to_lose;
    Triangulation made;
    if (is_improvement()) {
      report_.seconds.triangulate = timed([&] {
        made = mesh_from_triangles(*input_.triangles);
        make_delaunay(made.mesh);
      });
    } else {
      report_.seconds.triangulate =
          timed([&] { made = constrained_delaunay(input_.pslg, options_.triangulation); });
    }
    mesh_ = std::move(made.mesh);
    Entities entities = mesh_.entities();
    set_region_sizes(options_.sizes, entities);
    mesh_.set_entities(std::move(entities));
    const auto& found = made.report.warnings;
    report_.warnings.insert(report_.warnings.end(), found.begin(), found.end());
  }

  void raise_angles(RefineOptions options) {
    const bool paper = options_.method == Method::paper;
    if (paper) options.placement = Placement::midpoint;
    const bool together = options_.nonobtuse && !paper;
    options.obtuse = together ? ObtuseRule::split_first : ObtuseRule::ignore;
    refined_ = refine(mesh_, options);
  }

  // The post-process may leave angles below the bound and moves triangles, so what is unfinished
  // is judged anew, without inserting anything more.
  void remove_obtuse_angles() {
    NonobtuseOptions nonobtuse;
    nonobtuse.max_vertices = options_.refine.max_vertices;
    const NonobtuseReport removed = make_boundary_nonobtuse(mesh_, nonobtuse);
    RefineOptions asked = options_.refine;
    asked.obtuse = ObtuseRule::split_first;
    const auto why = own_reason(refined_);
    const RefineReport judged =
        judge(mesh_, asked, why.value_or(removed.goal_reached ? Reason::method : Reason::budget));
    refined_.unfinished = judged.unfinished;
    refined_.goal_reached = judged.goal_reached && removed.goal_reached;
  }

  // Cutting bent curves makes a mesh grow, and validate() looks at a triangle's neighbours only.
  void refuse_overlap() {
    if (!has_bent_boundary(mesh_)) return;
    std::optional<std::pair<HalfEdge, HalfEdge>> meeting;
    report_.seconds.check = timed([&] { meeting = first_boundary_meeting(mesh_); });
    if (!meeting) return;
    const auto place = [&](HalfEdge e) {
      return to_text(mesh_.point(mesh_.origin(e))) + " to " +
             to_text(mesh_.point(mesh_.destination(e)));
    };
    throw InputError(
        mesh_.source() + ", boundary near " + to_text(mesh_.point(mesh_.origin(meeting->first))),
        "pieces of its curves meet: " + place(meeting->first) + " and " + place(meeting->second),
        "cut the curves closer with a smaller --chord-tolerance, or move them apart");
  }

  // Why refinement stopped short, where the input is not to blame.
  static std::optional<Reason> own_reason(const RefineReport& refined) {
    for (const Unfinished& u : refined.unfinished) {
      if (!is_forced_by_input(u.reason)) return u.reason;
    }
    return std::nullopt;
  }

  void note_stage(const std::string& name, std::size_t vertices_before) {
    report_.stages.push_back({name, {}, mesh_.vertex_count() - vertices_before});
  }

  // Before anything else changes the mesh.
  void measure_stage() {
    report_.seconds.measure += timed([&] { report_.stages.back().quality = measure(mesh_); });
  }

  // Checking and measuring take about as long as each other, and only read the mesh.
  void finish() {
    const bool is_large = mesh_.triangle_count() > 20'000;
    std::optional<EndsAtOnce> nothing_to_lose;
    if (!interrupted()) nothing_to_lose.emplace();  // else the report tells of what was cancelled
    in_parallel(
        is_large ? threads() : 1, [&] { report_.seconds.check += timed([&] { check(); }); },
        [&] {
          certify_boxes();
          measure_stage();
          report_.seconds.measure += timed([&] { report_.groups = group_figures(mesh_); });
        });
    report_.quality = report_.stages.back().quality;
    report_.steiner_points = mesh_.vertex_count() - report_.input_vertices;
    report_.below_bound = count_reasons(refined_.unfinished);
    report_.goal_reached = refined_.goal_reached && !interrupted();
  }

  unsigned threads() const {
    const unsigned asked = options_.triangulation.threads;
    return asked > 0 ? asked : std::thread::hardware_concurrency();
  }

  // A plain triangulation is not made for finite volumes: only asked for, it is certified.
  void certify_boxes() {
    if (!asks_for_angles() && !options_.certify) return;
    Certificate certificate;
    if (!interrupted()) report_.seconds.voronoi = timed([&] { certificate = certify(mesh_); });
    report_.admissible = certificate.admissible;
    report_.offending_edges = offending_edges(mesh_, certificate);
  }

  void check() {
    MeshClaims claims;
    if (options_.refine.min_angle_deg > 0) claims.min_angle_deg = options_.refine.min_angle_deg;
    if (options_.refine.max_angle_deg < 180) claims.max_angle_deg = options_.refine.max_angle_deg;
    claims.nonobtuse = options_.nonobtuse;
    claims.unfinished = refined_.unfinished;
    const MeshReport checked = validate(mesh_, claims);
    report_.valid = checked.valid();
    report_.violations = checked.violations;
  }

  const Input& input_;
  MeshOptions options_;
  Mesh mesh_;
  RefineReport refined_;
  RunReport report_;
};

}  // namespace

Meshed make_mesh(const Input& input, const MeshOptions& options) {
  return Pipeline(input, options).run();
}

}  // namespace lepp::cli
