#include "lepp/terrain/lepp_loop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/triangle_measures.hpp"
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

constexpr std::uint8_t most_moves = 20;

}  // namespace

LeppLoop::LeppLoop(const HeightGrid& grid, TerrainMesh& terrain, const SimplifyOptions& options)
    : grid_(grid),
      terrain_(terrain),
      mesh_(terrain.mesh()),
      angle_(options.min_angle_deg),
      bound_(AngleTest::squared_cos(options.min_angle_deg)),
      off_centre_(options.min_angle_deg),
      place_(options.min_angle_deg),
      frozen_(mesh_.vertex_count()),
      floor_(default_size_floor(mesh_)) {
  target_options_.min_angle_deg = options.min_angle_deg;
}

void LeppLoop::run(double error, std::size_t vertices) {
  error_ = error;
  most_vertices_ = vertices;
  targets_.emplace(mesh_, target_options_);
  heap_.emplace(error);
  for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
    targets_->add(mesh_, TriangleId(t));
    heap_->set(TriangleId(t), terrain_.error(TriangleId(t)));
  }
  while (mesh_.vertex_count() < most_vertices_ && take_turn()) note_changes();
}

double LeppLoop::largest_error() const {
  double largest = 0;
  for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
    largest = std::max(largest, terrain_.error(TriangleId(t)));
  }
  // Nothing left to do: what is still off can not be mended.
  return heap_->top() ? largest : std::min(largest, error_);
}

void LeppLoop::note_changes() {
  terrain_.add_heights();
  std::ranges::sort(changed_);
  changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
  terrain_.rescan(changed_);
  for (const TriangleId t : changed_) {
    targets_->add(mesh_, t);
    heap_->set(t, terrain_.error(t));
  }
}

bool LeppLoop::take_turn() {
  changed_.clear();
  if (const auto t = targets_->next(mesh_)) {
    if (is_improvable(*t)) {
      const auto before = mesh_.vertices(*t);
      if (improve(*t) && mesh_.vertices(*t) == before) targets_->add(mesh_, *t);
    }
    return true;
  }
  if (const auto t = heap_->top()) {
    reduce_error(*t);
    if (changed_.empty()) heap_->set(*t, 0);
    return true;
  }
  return false;
}

bool LeppLoop::is_improvable(TriangleId t) const {
  return !smallest_angle_between_constrained(mesh_, t) && !shortest_edge_is_seditious(mesh_, t) &&
         !at_input_feature(mesh_, t, 2 * floor_);
}

bool LeppLoop::improve(TriangleId t) {
  if (move_a_corner(t)) return true;
  const auto [a, b, c] = mesh_.corners(t);
  return insert_near(t, in_supported_range(off_centre_(a, b, c)));
}

bool LeppLoop::move_a_corner(TriangleId t) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (move_corner(t, i)) return true;
  }
  return false;
}

bool LeppLoop::move_corner(TriangleId t, std::uint32_t corner) {
  const VertexId v = mesh_.vertex(t, corner);
  if (v.index() < frozen_ || mesh_.origin_of(v).kind != VertexOrigin::Kind::interior) return false;
  if (moves_.size() <= v.index()) moves_.resize(2 * mesh_.vertex_count(), 0);
  if (moves_[v.index()] == most_moves || !find_star(mesh_, t, corner, star_, 12)) return false;
  const auto place = place_.find(star_, mesh_.point(v));
  if (!place) return false;
  double before = error_;
  for (const auto& side : star_.link) before = std::max(before, terrain_.error(side.edge.triangle));
  for (const Point p : {snapped(*place), in_supported_range(*place)}) {
    if (!sees_link(star_, p)) continue;
    bool good = true;
    for (std::size_t i = 0; good && i < star_.size(); ++i) {
      good = !angle_.is_below(p, star_.from(i), star_.to(i)) &&
             !(star_.link[i].constrained && would_encroach(mesh_, star_.link[i].edge, p));
    }
    if (!good || error_of_star(star_, p) > before) continue;
    move_vertex(mesh_, v, star_, p, changed_);
    terrain_.set_height(v);
    ++moves_[v.index()];
    return true;
  }
  return false;
}

double LeppLoop::error_of_star(const Star& star, Point p) const {
  const TerrainCorner center = terrain_.space().corner(p, terrain_.height_of(p));
  double worst = 0;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const HalfEdge e = star.link[i].edge;
    worst = std::max(worst, terrain_.scan()
                                .worst({center, terrain_.corner(mesh_.origin(e)),
                                        terrain_.corner(mesh_.destination(e))})
                                .error);
  }
  return worst;
}

bool LeppLoop::find_cavity(TriangleId t, Point p) {
  const WayEnd end = straight_walk(mesh_, t, p);
  barrier_ = end.barrier;
  if (end.barrier || !contains(mesh_, end.triangle, p)) return false;
  if (cavity_.find(mesh_, end.triangle, p)) return true;
  barrier_ = encroached_by(p);  // p lies on it
  return false;
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
  stack_.clear();
  for (const TriangleId t : cavity_.triangles()) {
    stack_.push_back({t, 0});
    stack_.push_back({t, 1});
  }
  restore_delaunay(mesh_, stack_, &changed_);
}

// The place for a triangle with a small angle: in the cavity of p where all angles are good, else
// p.
bool LeppLoop::insert_near(TriangleId t, Point p) {
  const Point near = snapped(p);
  for (const Point q : {near, p}) {
    if (!find_cavity(t, q)) continue;
    star_.link.clear();
    for (const auto& rim : cavity_.rim())
      star_.link.push_back({rim.inside, rim.from, rim.constrained});
    const auto place = place_.find(star_, q);
    if (!place) continue;
    for (const Point r : {snapped(*place), in_supported_range(*place)}) {
      if (!sees_link(star_, r) || encroached_by(r) || badness_of_star(r) > bound_) continue;
      fill(r);
      return true;
    }
  }
  for (const Point q : {near, p}) {
    if (q != p &&
        squared_distance(p, q) > 0.02 * squared_distance(mesh_.point(mesh_.vertex(t, 0)), p))
      continue;
    if (!find_cavity(t, q)) {
      if (q == p && barrier_) return cut(*barrier_);
      continue;
    }
    if (const auto e = encroached_by(q)) {
      if (cut(*e)) return true;
      if (q == p) return false;
      continue;
    }
    fill(q);
    return true;
  }
  return false;
}

// What to do about a triangle that is off: its worst sample if the star of that is good, else a
// good place in its cavity, else at the end of the LEPP; else whatever has the best angles.
void LeppLoop::reduce_error(TriangleId t) {
  const Sample s = terrain_.worst(t).at;
  const Point p = terrain_.space().place(s);
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge e{t, i};
    if (!mesh_.is_constrained(e)) continue;
    const Point a = mesh_.point(mesh_.origin(e)), b = mesh_.point(mesh_.destination(e));
    const double twice_area = cross(b - a, p - a);
    if (twice_area * twice_area <= 1e-17 * squared_distance(a, b)) {
      if (!cut_near(e, p)) terrain_.insert(t, s, changed_);
      return;
    }
  }
  std::optional<Candidate> best;
  const auto try_place = [&](Point q) {
    if (!find_cavity(t, q) || encroached_by(q)) return false;
    const double badness = badness_of_star(q);
    if (badness <= bound_) {
      fill(q);
      return true;
    }
    if (!best || badness < best->badness) best = Candidate{q, badness};
    return false;
  };
  if (try_place(p)) return;
  if (find_cavity(t, p)) {
    star_.link.clear();
    for (const auto& rim : cavity_.rim())
      star_.link.push_back({rim.inside, rim.from, rim.constrained});
    if (const auto place = place_.find(star_, p)) {
      if (try_place(snapped(*place))) return;
    }
  }
  const HalfEdge terminal = terminal_edge(mesh_, t);
  const Point middle =
      midpoint(mesh_.point(mesh_.origin(terminal)), mesh_.point(mesh_.destination(terminal)));
  const double longest = squared_distance(mesh_.point(mesh_.origin(terminal)),
                                          mesh_.point(mesh_.destination(terminal)));
  if (mesh_.is_constrained(terminal)) {
    if (cut(terminal)) return;
  } else if (longest > 4 && try_place(snapped(middle))) {
    return;
  }
  if (longest > 4 && best && find_cavity(t, best->place)) {
    fill(best->place);
    return;
  }
  if (find_cavity(t, p)) {
    if (const auto e = encroached_by(p); e && cut(*e)) return;
    if (find_cavity(t, p)) {
      fill(p);
      return;
    }
  }
  terrain_.insert(t, s, changed_);
}

bool LeppLoop::cut_near(HalfEdge e, Point p) {
  const Point a = mesh_.point(mesh_.origin(e)), b = mesh_.point(mesh_.destination(e));
  const double s = std::clamp(dot(p - a, b - a) / squared_distance(a, b), 0.35, 0.65);
  const Point q = snapped(a + s * (b - a));
  if (squared_distance(a, b) < 9 || orient2d(a, b, q) != 0) return false;
  return terrain_.insert(e.triangle, terrain_.space().nearest(q), changed_);
}

bool LeppLoop::cut(HalfEdge e) {
  if (!terrain_.may_cut(e)) return false;
  const Point a = mesh_.point(mesh_.origin(e)), b = mesh_.point(mesh_.destination(e));
  if (cut_near(e, midpoint(a, b))) return true;
  const auto split = split_constrained_edge(mesh_, e, floor_);
  changed_.insert(changed_.end(), split.changed.begin(), split.changed.end());
  return !split.vertices.empty();
}

Point LeppLoop::snapped(Point p) const {
  const Sample s = terrain_.space().nearest(p);
  return std::isnan(terrain_.space().height(s)) ? p : terrain_.space().place(s);
}

}  // namespace lepp
