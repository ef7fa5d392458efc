#include "lepp/terrain/surface_loop.hpp"

#include <limits>

#include "lepp/terrain/terrain_errors.hpp"
#include "lepp/triangulation/lepp.hpp"

namespace lepp {

namespace {

// Halves of shorter edges, in cells, say no more than samples do.
constexpr double long_edge = 2;

}  // namespace

SurfaceLoop::SurfaceLoop(TerrainMesh& terrain, double min_angle_deg, std::function<bool()> go_on)
    : terrain_(terrain),
      mesh_(terrain.mesh()),
      go_on_(std::move(go_on)),
      angle_(min_angle_deg),
      plan_angle_(plan_angle_deg(min_angle_deg)),
      bound_(AngleTest::squared_cos(min_angle_deg)),
      plan_bound_(AngleTest::squared_cos(plan_angle_deg(min_angle_deg))),
      editor_(terrain, plan_angle_deg(min_angle_deg)),
      repair_(editor_, min_angle_deg, plan_angle_deg(min_angle_deg)),
      budget_(vertex_budget(terrain)) {}

void SurfaceLoop::run(double error, std::size_t vertices) {
  most_vertices_ = vertices;
  editor_.set_most_vertices(vertices);
  start(error);
  while (mesh_.vertex_count() < most_vertices_ && may_go_on() && take_turn()) {
  }
  editor_.flip_planar_back();  // the budget may have ended before that
  note_changes();
}

bool SurfaceLoop::may_go_on() {
  ++turns_;
  cancelled_ = cancelled_ || !go_on_();
  return !cancelled_ && !out_of_budget();
}

void SurfaceLoop::take_over(std::span<const Unfinished> unfinished) {
  is_new_ = true;
  repair_.at_kept_border().clear();
  for (const Unfinished& u : unfinished) {
    if (u.reason == Reason::kept_border) repair_.at_kept_border().add(mesh_, u.triangle);
  }
}

void SurfaceLoop::start(double error) {
  error_ = error;
  // Rules that go by errors need those of the worst samples.
  terrain_.set_enough(std::numeric_limits<double>::infinity());
  terrain_.rescan_all();
  editor_.flips().set_error(error);
  repair_.set_error(error);
  heap_ = errors_above(terrain_, error);
  thin_ = {};
  small_ = {};
  for (std::size_t i = 0; i < mesh_.triangle_count(); ++i) {
    const TriangleId t(i);
    const auto [a, b, c] = mesh_.corners(t);
    if (!is_new_) add_if_thin(t);
    if (!is_new_ || !angle_.is_below(a, b, c)) add_if_small(t);
  }
  is_new_ = false;
  editor_.flip_everywhere();
  note_changes();
}

double SurfaceLoop::largest_error() const { return lepp::largest_error(terrain_, *heap_); }

void SurfaceLoop::add_if_thin(TriangleId t) {
  const auto [a, b, c] = mesh_.corners(t);
  if (plan_angle_.is_below(a, b, c)) {
    thin_.push({AngleTest::badness(a, b, c), t, mesh_.vertices(t)});
  }
}

void SurfaceLoop::add_if_small(TriangleId t) {
  const auto [p, q, r] = editor_.metric().corners(t);
  if (angle_.is_below(squared_distance(p, q), squared_distance(q, r), squared_distance(r, p))) {
    small_.push({badness(p, q, r), t, mesh_.vertices(t)});
  }
}

void SurfaceLoop::note_changes() {
  for (const TriangleId t : editor_.changed()) {
    heap_->set(t, terrain_.error(t));
    add_if_thin(t);
    add_if_small(t);
  }
  editor_.forget();
}

std::optional<TriangleId> SurfaceLoop::next(Targets& targets) {
  while (!targets.empty()) {
    const Target target = targets.top();
    targets.pop();
    if (mesh_.vertices(target.triangle) == target.vertices) return target.triangle;
  }
  return std::nullopt;
}

// Thin triangles in plan first, then errors; once both are done what was planar goes back to the
// metric of space; then small angles there.
bool SurfaceLoop::take_turn() {
  if (const auto thin = next(thin_)) {
    widen(*thin);
  } else if (const auto worst = heap_->top()) {
    reduce_error(*worst);
    if (!editor_.has_changed()) heap_->set(*worst, 0);
  } else if (editor_.flips().any_planar()) {
    return flip_back();
  } else if (const auto small = next(small_)) {
    if (is_improvable(mesh_, *small, editor_.floor())) repair_.improve(*small, Kind::space);
  } else {
    return false;
  }
  note_changes();
  return true;
}

// A cut elsewhere, or a vertex, may leave the triangle to be tried again.
void SurfaceLoop::widen(TriangleId t) {
  if (!is_improvable(mesh_, t, editor_.floor())) return;
  const auto before = mesh_.vertices(t);
  repair_.improve(t, Kind::plan);
  if (editor_.has_changed() && mesh_.vertices(t) == before) add_if_thin(t);
}

// Thin triangles that come back although no vertex came or moved have been tried in vain. So there
// are no more rounds than insertions and moves.
bool SurfaceLoop::flip_back() {
  editor_.flip_planar_back();
  note_changes();
  const std::size_t work = mesh_.vertex_count() + editor_.moves();
  if (work == work_at_flip_) thin_ = {};
  work_at_flip_ = work;
  return true;
}

// By the metric of space; where no insertion is tame in it, by that of the plan.
void SurfaceLoop::reduce_error(TriangleId t) {
  const Sample s = terrain_.worst(t).at;
  if (cut_line_at(t, s)) return;
  const Point p = terrain_.space().place(s);
  if (!insert_in_space(t, p)) insert_in_plan(t, p);
}

// \return true if the sample is on a line; then there is no other place for it
bool SurfaceLoop::cut_line_at(TriangleId t, Sample s) {
  const Point p = terrain_.space().place(s);
  const auto e = terrain_.constrained_edge_at(t, p);
  if (!e) return false;
  if (terrain_.is_hard(*e)) return true;
  const Point a = mesh_.point(mesh_.origin(*e)), b = mesh_.point(mesh_.destination(*e));
  const double part = dot(p - a, b - a) / squared_distance(a, b);
  const auto near = terrain_.sample_inside(*e, part);
  if (near && editor_.cut_at(*e, *near)) return true;
  if (!editor_.cut_at(*e, p)) editor_.cut_at(*e, a + part * (b - a));
  return true;
}

// Inserts if the star is good, else remembers the place if it is the best so far.
bool SurfaceLoop::take_if_good(Point p, double badness, TerrainMetric metric) {
  if (badness <= bound_) {
    editor_.fill(metric);
    return true;
  }
  best_.note(p, badness);
  return false;
}

bool SurfaceLoop::insert_best(TriangleId t, TerrainMetric metric) {
  if (!best_.exists() || !editor_.grow(t, best_.place(), metric)) return false;
  editor_.fill(metric);
  return true;
}

Point SurfaceLoop::middle(HalfEdge e) const {
  return midpoint(mesh_.point(mesh_.origin(e)), mesh_.point(mesh_.destination(e)));
}

// ---- in space: tame stars only -------------------------------------------------------------

bool SurfaceLoop::try_in_space(TriangleId t, Point p) {
  if (!editor_.grow(t, p, TerrainMetric::surface)) return false;
  const SurfaceStar& star = editor_.star();
  if (star.encroached() || !star.is_tame() || star.badness_in_plan() > plan_bound_) return false;
  if (star.clearance() < editor_.clearance()) return false;
  return take_if_good(p, star.badness_in_space(), TerrainMetric::surface);
}

// The worst sample if its star is good in space, else a good place in that star, else the end of
// the LEPP; else whichever of them is best.
bool SurfaceLoop::insert_in_space(TriangleId t, Point p) {
  best_.clear();
  if (try_in_space(t, p)) return true;
  if (editor_.grow(t, p, TerrainMetric::surface)) {
    const auto place = repair_.good_place_near(p, Kind::space);
    if (place && try_in_space(t, terrain_.snapped(*place))) return true;
  }
  const HalfEdge terminal = editor_.metric().terminal_edge(t);
  if (mesh_.is_constrained(terminal)) {
    if (editor_.cut(terminal, editor_.clearance())) return true;
  } else if (try_in_space(terminal.triangle, terrain_.snapped(middle(terminal)))) {
    return true;
  }
  return insert_best(t, TerrainMetric::surface);
}

// ---- in plan -------------------------------------------------------------------------------

bool SurfaceLoop::try_in_plan(TriangleId t, Point p) {
  if (!editor_.grow(t, p, TerrainMetric::planar) || editor_.star().encroached()) return false;
  return take_if_good(p, editor_.star().badness_in_plan(), TerrainMetric::planar);
}

// The same in plan; at last the worst sample itself, whatever its star is like.
void SurfaceLoop::insert_in_plan(TriangleId t, Point p) {
  best_.clear();
  if (try_in_plan(t, p)) return;
  if (editor_.grow(t, p, TerrainMetric::planar)) {
    const auto place = repair_.good_place_near(p, Kind::plan);
    if (place && try_in_plan(t, terrain_.snapped(*place))) return;
  }
  const HalfEdge terminal = terminal_edge(mesh_, t);
  const bool is_long =
      squared_distance(mesh_.point(mesh_.origin(terminal)),
                       mesh_.point(mesh_.destination(terminal))) > long_edge * long_edge;
  if (mesh_.is_constrained(terminal)) {
    if (editor_.cut(terminal, editor_.clearance())) return;
  } else if (is_long && try_in_plan(terminal.triangle, terrain_.snapped(middle(terminal)))) {
    return;
  }
  if (is_long && insert_best(t, TerrainMetric::planar)) return;
  if (!editor_.grow(t, p, TerrainMetric::planar)) return;
  if (const auto e = editor_.star().encroached(); e && editor_.cut(*e, editor_.clearance())) return;
  if (editor_.grow(t, p, TerrainMetric::planar)) editor_.fill(TerrainMetric::planar);
}

}  // namespace lepp
