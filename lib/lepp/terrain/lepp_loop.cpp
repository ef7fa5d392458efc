#include "lepp/terrain/lepp_loop.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lepp/geometry/predicates.hpp"
#include "lepp/refine/straight_walk.hpp"
#include "lepp/triangulation/encroached.hpp"
#include "lepp/triangulation/flip.hpp"
#include "lepp/triangulation/lepp.hpp"
#include "lepp/triangulation/locate.hpp"
#include "lepp/triangulation/sharp_vertex.hpp"
#include "lepp/triangulation/split.hpp"
#include "lepp/triangulation/split_constrained.hpp"

namespace lepp {

namespace {

// One move may undo another, so that only a limit makes an end certain; few get near it.
constexpr std::uint8_t most_moves = 20;
// A fuller star hardly ever has a place with all angles good.
constexpr std::size_t most_triangles = 12;
// Edges shorter than this, in cells, leave no choice between samples.
constexpr double short_edge = 2;
// A line is cut at a sample in the middle part of it, if it is long enough to have one there.
constexpr double first_part = 0.35, shortest_with_choice = 3;
// An off-centre may move to the next sample if that is this much nearer than the triangle.
constexpr double near_enough = 0.02;

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
      frozen_(mesh_.vertex_count()),
      budget_(4 * terrain.grid().size() + 50 * (mesh_.vertex_count() + 1000)) {
  asked_.min_angle_deg = min_angle_deg;
}

void LeppLoop::run(double error, std::size_t vertices) {
  error_ = error;
  kept_.reset();
  const bool is_limited = vertices < std::numeric_limits<std::size_t>::max();
  terrain_.set_enough(is_limited ? std::numeric_limits<double>::infinity() : error);
  start();
  while (may_go_on() && take_turn(vertices)) note_changes();
  if (!kept_ || (mesh_.vertex_count() <= vertices && heap_->top_error() <= kept_error_)) return;
  terrain_.restore(std::move(*kept_));
  kept_.reset();
  start();
}

bool LeppLoop::met_kept_border(TriangleId t) const {
  return std::ranges::find(at_kept_border_, mesh_.vertices(t)) != at_kept_border_.end();
}

void LeppLoop::start() {
  at_kept_border_.clear();
  moves_.clear();
  if (any_sharp_) encroached_.emplace(mesh_);
  targets_.emplace(mesh_, asked_);
  heap_.emplace(error_);
  for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
    targets_->add(mesh_, TriangleId(t));
    heap_->set(TriangleId(t), terrain_.error(TriangleId(t)));
  }
}

bool LeppLoop::may_go_on() {
  cancelled_ = cancelled_ || !go_on_();
  return !cancelled_ && !out_of_budget();
}

double LeppLoop::largest_error() const {
  double largest = 0;
  for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
    largest = std::max(largest, terrain_.error(TriangleId(t)));
  }
  return heap_->top() ? largest : std::min(largest, error_);
}

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
    if (!is_improvable(*t)) return true;
    const auto before = mesh_.vertices(*t);
    if (improve(*t) && mesh_.vertices(*t) == before) targets_->add(mesh_, *t);
    return true;
  }
  if (mesh_.vertex_count() > vertices) return false;
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

// ---- small angles -------------------------------------------------------------------------------

bool LeppLoop::is_improvable(TriangleId t) const {
  return !smallest_angle_between_constrained(mesh_, t) && !shortest_edge_is_seditious(mesh_, t) &&
         !at_input_feature(mesh_, t, 2 * floor_);
}

// As UnifiedLoop does, but for the samples.
bool LeppLoop::improve(TriangleId t) {
  if (move_a_corner(t)) return true;
  const auto [a, b, c] = mesh_.corners(t);
  const Point p = in_supported_range(off_centre_(a, b, c)), at_sample = terrain_.snapped(p);
  if (insert_at_good_place(t, at_sample) || insert_at_good_place(t, p)) return true;
  if (squared_distance(p, at_sample) <= near_enough * squared_distance(a, p) &&
      find_cavity(t, at_sample) && !encroached_by(at_sample)) {
    fill(at_sample);
    return true;
  }
  return insert_or_cut(t, p);
}

bool LeppLoop::move_a_corner(TriangleId t) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (!find_free_star(t, i)) continue;
    const VertexId v = mesh_.vertex(t, i);
    const auto place = place_.find(star_, mesh_.point(v));
    if (!place) continue;
    double limit = error_;
    for (const auto& side : star_.link) {
      limit = std::max(limit, terrain_.error(side.edge.triangle));
    }
    for (const Point p : {terrain_.snapped(*place), in_supported_range(*place)}) {
      if (!is_good_center(p) || error_of_star(p) > limit) continue;
      if (any_sharp_ && encroaches_beyond_link(mesh_, star_, p, suspects_)) continue;
      move_vertex(mesh_, v, star_, p, changed_);
      terrain_.set_height(v);
      ++moves_[v.index()];
      return true;
    }
  }
  return false;
}

bool LeppLoop::find_free_star(TriangleId t, std::uint32_t corner) {
  const VertexId v = mesh_.vertex(t, corner);
  if (v.index() < frozen_ || mesh_.origin_of(v).kind != VertexOrigin::Kind::interior) return false;
  if (moves_.size() <= v.index()) moves_.resize(2 * mesh_.vertex_count(), 0);
  return moves_[v.index()] < most_moves && find_star(mesh_, t, corner, star_, most_triangles);
}

bool LeppLoop::is_good_center(Point p) const {
  if (!sees_link(star_, p)) return false;
  for (std::size_t i = 0; i < star_.size(); ++i) {
    const auto& [edge, from, constrained] = star_.link[i];
    if (angle_.is_below(p, from, star_.to(i))) return false;
    if (constrained && would_encroach(mesh_, edge, p)) return false;
  }
  return true;
}

double LeppLoop::error_of_star(Point p) const {
  const TerrainCorner center = terrain_.space().corner(p, terrain_.height_of(p));
  double worst = 0;
  for (const auto& side : star_.link) {
    const auto found = terrain_.scan().worst({center, terrain_.corner(mesh_.origin(side.edge)),
                                              terrain_.corner(mesh_.destination(side.edge))});
    worst = std::max(worst, found.error);
  }
  return worst;
}

bool LeppLoop::insert_at_good_place(TriangleId t, Point p) {
  if (!find_cavity(t, p)) return false;
  const auto place = good_place_in_cavity(p);
  if (!place) return false;
  for (const Point q : {terrain_.snapped(*place), in_supported_range(*place)}) {
    if (!sees_link(star_, q) || encroached_by(q) || badness_of_star(q) > bound_) continue;
    if (any_sharp_ && encroaches_beyond_link(mesh_, star_, q, suspects_)) continue;
    fill(q);
    return true;
  }
  return false;
}

bool LeppLoop::insert_or_cut(TriangleId t, Point p) {
  if (!find_cavity(t, p)) return barrier_ && cut(*barrier_);
  if (const auto e = encroached_by(p)) return cut(*e);
  fill(p);
  return true;
}

// ---- errors -------------------------------------------------------------------------------------

// The worst sample, if all angles around it would be good; else such a place in its cavity; else
// the end of the LEPP; else whichever of these has the best angles. Among the samples themselves
// there is no choice: then the worst one, whatever its angles.
void LeppLoop::reduce_error(TriangleId t) {
  const Sample s = terrain_.worst(t).at;
  if (cut_line_at(t, s)) return;
  const Point p = terrain_.space().place(s);
  best_.reset();
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
  if (!best_ || badness < best_->badness) best_ = Candidate{p, badness};
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
  if (!best_ || !find_cavity(t, best_->place)) return false;
  fill(best_->place);
  return true;
}

// ---- places and cuts ----------------------------------------------------------------------------

bool LeppLoop::find_cavity(TriangleId t, Point p) {
  const WayEnd end = straight_walk(mesh_, t, p);
  barrier_ = end.barrier;
  if (end.barrier || !contains(mesh_, end.triangle, p)) return false;
  if (cavity_.find(mesh_, end.triangle, p)) return true;
  barrier_ = encroached_by(p);  // p lies on it
  return false;
}

// Leaves the rim of the cavity in star_.
std::optional<Point> LeppLoop::good_place_in_cavity(Point near) {
  star_.link.clear();
  for (const auto& rim : cavity_.rim()) {
    star_.link.push_back({rim.inside, rim.from, rim.constrained});
  }
  return place_.find(star_, near);
}

std::optional<HalfEdge> LeppLoop::encroached_by(Point p) const {
  for (const auto& rim : cavity_.rim()) {
    if (rim.constrained && would_encroach(mesh_, rim.inside, p)) return rim.inside;
  }
  return std::nullopt;
}

double LeppLoop::badness_of_star(Point p) const {
  double worst = 0;
  const auto rim = cavity_.rim();
  for (std::size_t i = 0; i < rim.size(); ++i) {
    worst = std::max(worst, AngleTest::badness(p, rim[i].from, cavity_.to(i)));
  }
  return worst;
}

void LeppLoop::fill(Point p) {
  cavity_.fill(mesh_, p, {VertexOrigin::Kind::interior, 0});
  changed_.insert(changed_.end(), cavity_.triangles().begin(), cavity_.triangles().end());
  suspects_.clear();
  for (const TriangleId t : cavity_.triangles()) {
    suspects_.push_back({t, 0});
    suspects_.push_back({t, 1});  // one spoke of each triangle
  }
  restore_delaunay(mesh_, suspects_, &changed_);
}

bool LeppLoop::cut(HalfEdge e) {
  if (!terrain_.may_cut(e)) {
    if (target_) at_kept_border_.push_back(mesh_.vertices(*target_));
    return false;
  }
  const Point a = mesh_.point(mesh_.origin(e)), b = mesh_.point(mesh_.destination(e));
  if (cut_at_sample_near(e, midpoint(a, b))) return true;
  const ConstrainedSplit split = split_constrained_edge(mesh_, e, floor_);
  changed_.insert(changed_.end(), split.changed.begin(), split.changed.end());
  return !split.vertices.empty();
}

bool LeppLoop::cut_at_sample_near(HalfEdge e, Point p) {
  if (squared_length(e) < shortest_with_choice * shortest_with_choice || is_sharp(e)) return false;
  const Point a = mesh_.point(mesh_.origin(e)), b = mesh_.point(mesh_.destination(e));
  const double part =
      std::clamp(dot(p - a, b - a) / squared_distance(a, b), first_part, 1 - first_part);
  const Point q = terrain_.snapped(a + part * (b - a));
  return orient2d(a, b, q) == 0 &&
         terrain_.insert(e.triangle, terrain_.space().nearest(q), changed_);
}

// Edges at a sharp vertex are cut at common radii, not where a sample is.
bool LeppLoop::is_sharp(HalfEdge e) const {
  if (!any_sharp_) return false;
  const auto is_center = [&](VertexId v) {
    return mesh_.is_input(v) && fan_at(mesh_, e, v).exists();
  };
  return is_center(mesh_.origin(e)) || is_center(mesh_.destination(e));
}

double LeppLoop::squared_length(HalfEdge e) const {
  return squared_distance(mesh_.point(mesh_.origin(e)), mesh_.point(mesh_.destination(e)));
}

}  // namespace lepp
