#include "lepp/terrain/lepp_loop.hpp"

#include <algorithm>
#include <utility>

#include "lepp/terrain/terrain_errors.hpp"
#include "lepp/triangulation/lepp.hpp"
#include "lepp/triangulation/sharp_vertex.hpp"

namespace lepp {

namespace {

// Edges shorter than this, in cells, leave no choice between samples.
constexpr double short_edge = 2;

// Below a degree places are looked for as for one.
double of_places(double min_angle_deg) { return std::max(min_angle_deg, 1.0); }

}  // namespace

LeppLoop::LeppLoop(TerrainMesh& terrain, double min_angle_deg, std::function<bool()> go_on)
    : terrain_(terrain),
      mesh_(terrain.mesh()),
      go_on_(std::move(go_on)),
      angle_(min_angle_deg),
      bound_(AngleTest::squared_cos(min_angle_deg)),
      off_centre_(of_places(min_angle_deg)),
      place_(of_places(min_angle_deg)),
      floor_(default_size_floor(mesh_)),
      any_sharp_(segments_meet_sharply(mesh_)),
      budget_(vertex_budget(terrain)),
      free_stars_(mesh_) {
  asked_.min_angle_deg = min_angle_deg;
}

void LeppLoop::run(double error, std::size_t vertices) {
  error_ = error;
  kept_.reset();
  const bool is_limited = vertices < std::numeric_limits<std::size_t>::max();
  terrain_.set_enough(is_limited ? std::numeric_limits<double>::infinity() : error);
  start();
  within_.reset();
  while (mesh_.vertex_count() <= vertices && may_go_on()) {
    keep_within(vertices);
    if (!take_turn(vertices)) break;
    note_changes();
  }
  limited_ = mesh_.vertex_count() > vertices && !kept_;
  if (limited_) kept_ = std::exchange(within_, std::nullopt);
  if (!kept_ || (mesh_.vertex_count() <= vertices && heap_->top_error() <= kept_error_)) return;
  terrain_.restore(std::move(*kept_));
  kept_.reset();
  start();
}

void LeppLoop::start() {
  at_kept_border_.clear();
  free_stars_.forget_moves();
  if (any_sharp_) encroached_.emplace(mesh_);
  targets_.emplace(mesh_, asked_);
  for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) targets_->add(mesh_, TriangleId(t));
  heap_ = errors_above(terrain_, error_);
}

bool LeppLoop::may_go_on() {
  cancelled_ = cancelled_ || !go_on_();
  return !cancelled_ && !out_of_budget();
}

double LeppLoop::largest_error() const { return lepp::largest_error(terrain_, *heap_); }

void LeppLoop::note_changes() {
  terrain_.add_heights();
  std::ranges::sort(changed_);
  changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
  terrain_.rescan(changed_);
  terrain_.choose_diagonals(changed_, error_);
  if (encroached_) encroached_->update(mesh_, changed_);
  for (const TriangleId t : changed_) {
    targets_->add(mesh_, t);
    heap_->set(t, terrain_.error(t));
  }
}

// False if there is nothing left to do.
bool LeppLoop::take_turn(std::size_t vertices) {
  changed_.clear();
  target_.reset();
  if (const auto e = encroached_ ? encroached_->next(mesh_) : std::nullopt) {
    if (!at_input_feature(mesh_, e->triangle, 2 * floor_)) cut(*e);
    return true;
  }
  if (const auto t = targets_->next(mesh_)) {
    target_ = t;
    if (!is_improvable(mesh_, *t, floor_)) return true;
    const auto before = mesh_.vertices(*t);
    if (improve(*t) && mesh_.vertices(*t) == before) targets_->add(mesh_, *t);
    return true;
  }
  keep_if_best(vertices);
  const auto t = heap_->top();
  if (!t || mesh_.vertex_count() == vertices) return false;
  reduce_error(*t);
  if (changed_.empty()) heap_->set(*t, 0);
  return true;
}

// Small angles that an insertion leaves can take more vertices than there are to be: near the end
// the best that has been is kept.
void LeppLoop::keep_if_best(std::size_t vertices) {
  constexpr std::size_t few = 2000, last = 16;
  if (vertices == std::numeric_limits<std::size_t>::max()) return;
  const std::size_t count = mesh_.vertex_count();
  const std::size_t from = vertices < few ? vertices / 2 : vertices - last;
  const double error = heap_->top_error();
  if (count < from || (kept_ && error >= kept_error_)) return;
  kept_ = terrain_.save();
  kept_error_ = error;
}

// Where small angles take all vertices that there are to be, before an error was looked at.
void LeppLoop::keep_within(std::size_t vertices) {
  constexpr std::size_t most_at_once = 16;
  const std::size_t count = mesh_.vertex_count();
  if (kept_ || vertices - count >= most_at_once) return;
  if (!within_ || within_->tin.mesh.vertex_count() != count) within_ = terrain_.save();
}

// ---- errors -------------------------------------------------------------------------------------

// The worst sample, if all angles around it would be good; else such a place in its cavity; else
// the end of the LEPP; else whichever of these has the best angles. Among the samples themselves
// there is no choice: then the worst one, whatever its angles.
void LeppLoop::reduce_error(TriangleId t) {
  const Sample s = terrain_.worst(t).at;
  if (cut_line_at(t, s)) return;
  const Point p = terrain_.space().place(s);
  best_.clear();
  if (find_cavity(t, p) && (fill_if_good(p) || insert_near_worst(t, p))) return;
  const HalfEdge terminal = terminal_edge(mesh_, t);
  if (squared_length(terminal) > short_edge * short_edge) {
    if (insert_at_end_of_path(terminal) || insert_best(t)) return;
  }
  if (find_cavity(t, p)) {
    const auto e = encroached_by(p);
    if (e && cut(*e)) return;
  }
  terrain_.insert(t, s, changed_);
}

// True if the sample is on a line: that is cut there, or near there if that leaves better pieces.
bool LeppLoop::cut_line_at(TriangleId t, Sample s) {
  const Point p = terrain_.space().place(s);
  const auto e = terrain_.constrained_edge_at(t, p);
  if (!e) return false;
  if (is_sharp(*e) && cut(*e)) return true;
  if (!cut_at_sample_near(*e, p)) terrain_.insert(t, s, changed_);
  return true;
}

bool LeppLoop::insert_if_good(TriangleId t, Point p) {
  return find_cavity(t, p) && fill_if_good(p);
}

bool LeppLoop::fill_if_good(Point p) {
  if (encroached_by(p)) return false;
  const double badness = badness_of_star(p);
  if (badness <= bound_) {
    fill(p);
    return true;
  }
  best_.note(p, badness);
  return false;
}

bool LeppLoop::insert_near_worst(TriangleId t, Point p) {
  const auto place = good_place_in_cavity(p);
  return place && insert_if_good(t, terrain_.snapped(*place));
}

bool LeppLoop::insert_at_end_of_path(HalfEdge terminal) {
  if (mesh_.is_constrained(terminal)) return cut(terminal);
  const Point middle =
      midpoint(mesh_.point(mesh_.origin(terminal)), mesh_.point(mesh_.destination(terminal)));
  return insert_if_good(terminal.triangle, terrain_.snapped(middle));
}

bool LeppLoop::insert_best(TriangleId t) {
  if (!best_.exists() || !find_cavity(t, best_.place())) return false;
  fill(best_.place());
  return true;
}

}  // namespace lepp
