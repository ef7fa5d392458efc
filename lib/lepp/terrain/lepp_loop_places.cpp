// The places where LeppLoop puts vertices: for small angles, in cavities, and on lines.

#include <algorithm>

#include "lepp/refine/straight_walk.hpp"
#include "lepp/terrain/lepp_loop.hpp"
#include "lepp/terrain/terrain_errors.hpp"
#include "lepp/triangulation/flip.hpp"
#include "lepp/triangulation/locate.hpp"
#include "lepp/triangulation/sharp_vertex.hpp"
#include "lepp/triangulation/split_constrained.hpp"

namespace lepp {

namespace {

// A line is cut at a sample in the middle part of it, if it is long enough to have one there.
constexpr double shortest_with_choice = 3;
// An off-centre may move to the next sample if that is this much nearer than the triangle.
constexpr double near_enough = 0.02;
// Places between samples keep so far from their columns and lines, in cells, that no sample is on
// two sides of an edge by rounding.
constexpr double clear = 1e-6;

}  // namespace

// ---- small angles -------------------------------------------------------------------------------

// As UnifiedLoop does, but for the samples.
bool LeppLoop::improve(TriangleId t) {
  if (move_a_corner(t)) return true;
  const auto [a, b, c] = mesh_.corners(t);
  const Point p = terrain_.clear_of_samples(off_centre_(a, b, c), clear),
              at_sample = terrain_.snapped(p);
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
    if (!free_stars_.find(t, i, star_)) continue;
    const VertexId v = mesh_.vertex(t, i);
    const auto place = place_.find(star_, mesh_.point(v));
    if (!place) continue;
    const double limit = std::max(error_, lepp::largest_error(terrain_, star_));
    for (const Point p : {terrain_.snapped(*place), terrain_.clear_of_samples(*place, clear)}) {
      if (!is_good_center(p) || error_of_star(terrain_, star_, p) > limit) continue;
      if (any_sharp_ && encroaches_beyond_link(mesh_, star_, p, suspects_)) continue;
      move_vertex(mesh_, v, star_, p, changed_);
      terrain_.set_height(v);
      free_stars_.note_move(v);
      return true;
    }
  }
  return false;
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

bool LeppLoop::insert_at_good_place(TriangleId t, Point p) {
  if (!find_cavity(t, p)) return false;
  const auto place = good_place_in_cavity(p);
  if (!place) return false;
  for (const Point q : {terrain_.snapped(*place), terrain_.clear_of_samples(*place, clear)}) {
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

// ---- places and cuts ----------------------------------------------------------------------------

bool LeppLoop::find_cavity(TriangleId t, Point p) {
  const WayEnd end = straight_walk(mesh_, t, p);
  barrier_ = end.barrier;
  if (end.barrier || !contains(mesh_, end.triangle, p)) return false;
  if (cavity_.find(mesh_, end.triangle, p)) return !is_at_vertex(p);
  barrier_ = encroached_by(p);  // p lies on it
  return false;
}

// A cut of a line at a sample is off by rounding, and stands for the sample all the same.
bool LeppLoop::is_at_vertex(Point p) const {
  const double near = same_place * std::min(1.0, terrain_.grid().aspect());
  return std::ranges::any_of(
      cavity_.rim(), [&](const auto& rim) { return squared_distance(p, rim.from) < near * near; });
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
  if (!terrain_.may_cut(e)) return give_up_at_border();
  const Point a = mesh_.point(mesh_.origin(e)), b = mesh_.point(mesh_.destination(e));
  if (cut_at_sample_near(e, midpoint(a, b))) return true;
  if (!terrain_.may_cut_with_fan(e)) return give_up_at_border();
  const ConstrainedSplit split = split_constrained_edge(mesh_, e, floor_);
  changed_.insert(changed_.end(), split.changed.begin(), split.changed.end());
  return !split.vertices.empty();
}

// Notes the target in hand. Returns false: nothing was cut.
bool LeppLoop::give_up_at_border() {
  if (target_) at_kept_border_.add(mesh_, *target_);
  return false;
}

bool LeppLoop::cut_at_sample_near(HalfEdge e, Point p) {
  if (squared_length(e) < shortest_with_choice * shortest_with_choice || is_sharp(e)) return false;
  const Point a = mesh_.point(mesh_.origin(e)), b = mesh_.point(mesh_.destination(e));
  const auto q = terrain_.sample_inside(e, dot(p - a, b - a) / squared_distance(a, b));
  return q && terrain_.insert(e.triangle, terrain_.space().nearest(*q), changed_);
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
