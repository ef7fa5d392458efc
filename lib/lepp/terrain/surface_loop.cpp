#include "lepp/terrain/surface_loop.hpp"

#include <algorithm>
#include <cmath>

#include "lepp/geometry/predicates.hpp"
#include "lepp/refine/straight_walk.hpp"
#include "lepp/triangulation/encroached.hpp"
#include "lepp/triangulation/lepp.hpp"
#include "lepp/triangulation/locate.hpp"
#include "lepp/triangulation/sharp_vertex.hpp"
#include "lepp/triangulation/split.hpp"
#include "lepp/triangulation/split_constrained.hpp"
#include "lepp/triangulation/unfinished.hpp"

namespace lepp {

namespace {

constexpr std::uint8_t most_moves = 20;
constexpr std::size_t now_and_then = 1024;
// The parts of the bound that moves try to reach, one after the other.
constexpr double rungs[] = {1, 0.75, 0.55};
// Nearer to a constrained edge, in cells, a sample is on it.
constexpr double on_line = 2 * same_place;

}  // namespace

SurfaceLoop::SurfaceLoop(const HeightGrid& grid, TerrainMesh& terrain, double min_angle_deg,
                         std::function<bool()> go_on)
    : grid_(grid),
      terrain_(terrain),
      mesh_(terrain.mesh()),
      go_on_(std::move(go_on)),
      metric_(grid, terrain),
      flips_(metric_, terrain, std::min(plan_angle_deg, min_angle_deg)),
      new_star_(metric_, flips_, terrain),
      angle_(min_angle_deg),
      plan_angle_(std::min(plan_angle_deg, min_angle_deg)),
      bound_(AngleTest::squared_cos(min_angle_deg)),
      plan_bound_(AngleTest::squared_cos(std::min(plan_angle_deg, min_angle_deg))),
      off_centre_(min_angle_deg),
      clearance_((1 - same_place) * std::min(1.0, grid.aspect())),
      floor_(default_size_floor(mesh_)),
      budget_(mesh_.vertex_count() + 2 * grid.size() + 1000),
      frozen_(mesh_.vertex_count()) {
  for (const double part : rungs) ladder_.emplace_back(part * min_angle_deg);
}

void SurfaceLoop::run(double error, std::size_t vertices) {
  most_vertices_ = vertices;
  start(error);
  while (mesh_.vertex_count() < most_vertices_ && may_go_on() && take_turn()) {
  }
  flip_planar_back();  // the budget may have ended before that
}

bool SurfaceLoop::may_go_on() {
  if (++turns_ % now_and_then == 0) cancelled_ = cancelled_ || !go_on_();
  return !cancelled_ && !out_of_budget();
}

// What the coarse mesh has below the bound in plan, its own refinement could not better: it is no
// target unless something changes there.
void SurfaceLoop::start(double error) {
  error_ = error;
  flips_.set_error(error);
  heap_.emplace(error);
  thin_ = {};
  small_ = {};
  changed_.clear();
  for (std::size_t i = 0; i < mesh_.triangle_count(); ++i) {
    const TriangleId t(i);
    heap_->set(t, terrain_.error(t));
    const auto [a, b, c] = mesh_.corners(t);
    if (started_ || !angle_.is_below(a, b, c)) add_targets(t);
  }
  started_ = true;
  flip_everywhere();
}

void SurfaceLoop::flip_everywhere() {
  changed_.clear();
  suspects_.clear();
  for (std::size_t t = mesh_.triangle_count(); t-- > 0;) {
    for (std::uint32_t i = 0; i < 3; ++i) suspects_.push_back({TriangleId(t), i});
  }
  flips_.restore(suspects_, changed_);
  note_changes();
}

void SurfaceLoop::flip_planar_back() {
  changed_.clear();
  suspects_.clear();
  flips_.clear_planar(suspects_);
  flips_.restore(suspects_, changed_);
  note_changes();
}

double SurfaceLoop::largest_error() const {
  double largest = 0;
  for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
    largest = std::max(largest, terrain_.error(TriangleId(t)));
  }
  return heap_->top() ? largest : std::min(largest, error_);
}

void SurfaceLoop::add_targets(TriangleId t) {
  const auto [a, b, c] = mesh_.corners(t);
  if (const double bad = AngleTest::badness(a, b, c); plan_angle_.is_below(a, b, c)) {
    thin_.push({bad, t, mesh_.vertices(t)});
  }
  const auto [p, q, r] = metric_.corners(t);
  if (angle_.is_below(squared_distance(p, q), squared_distance(q, r), squared_distance(r, p))) {
    small_.push({badness(p, q, r), t, mesh_.vertices(t)});
  }
}

void SurfaceLoop::note_changes() {
  std::ranges::sort(changed_);
  changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
  for (const TriangleId t : changed_) {
    heap_->set(t, terrain_.error(t));
    add_targets(t);
  }
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
  changed_.clear();
  if (const auto t = next(thin_)) {
    if (is_improvable(*t)) improve(*t, Kind::plan);
  } else if (const auto worst = heap_->top()) {
    reduce_error(*worst);
    if (changed_.empty()) heap_->set(*worst, 0);
  } else if (flips_.any_planar()) {
    flip_planar_back();
    return true;
  } else if (const auto small = next(small_)) {
    if (is_improvable(*small)) improve(*small, Kind::space);
  } else {
    return false;
  }
  note_changes();
  return true;
}

bool SurfaceLoop::is_improvable(TriangleId t) const {
  return !smallest_angle_between_constrained(mesh_, t) && !shortest_edge_is_seditious(mesh_, t) &&
         !at_input_feature(mesh_, t, 2 * floor_);
}

// ---- errors --------------------------------------------------------------------------------

// By the metric of space, unless the triangle is planar for the time being or no insertion there is
// tame; then by that of the plan.
void SurfaceLoop::reduce_error(TriangleId t) {
  const Sample s = terrain_.worst(t).at;
  if (cut_line_at(t, s)) return;
  const Point p = terrain_.space().place(s);
  if (insert_in_space(t, p)) return;
  insert_in_plan(t, p);
}

// \return true if the sample is on a line; then there is no other place for it
bool SurfaceLoop::cut_line_at(TriangleId t, Sample s) {
  const Point p = terrain_.space().place(s);
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge e{t, i};
    if (!mesh_.is_constrained(e)) continue;
    const Point a = mesh_.point(mesh_.origin(e)), b = mesh_.point(mesh_.destination(e));
    const double twice_area = cross(b - a, p - a);
    if (twice_area * twice_area > on_line * on_line * squared_distance(a, b)) continue;
    if (terrain_.is_hard(e)) return true;
    const double part = dot(p - a, b - a) / squared_distance(a, b);
    const Point q = snapped(a + std::clamp(part, 0.35, 0.65) * (b - a));
    if (squared_distance(a, b) < 9 || orient2d(a, b, q) != 0 || !cut(e, q)) {
      if (!cut(e, p)) cut(e, a + part * (b - a));
    }
    return true;
  }
  return false;
}

bool SurfaceLoop::grow(TriangleId t, Point p, TerrainMetric metric) {
  const WayEnd end = straight_walk(mesh_, t, p);
  barrier_ = end.barrier;
  return !end.barrier && contains(mesh_, end.triangle, p) &&
         new_star_.grow(end.triangle, p, metric);
}

bool SurfaceLoop::try_in_space(TriangleId t, Point p, std::optional<Candidate>& best) {
  if (!grow(t, p, TerrainMetric::surface) || new_star_.encroached()) return false;
  if (!new_star_.is_tame() || new_star_.badness_in_plan() > plan_bound_) return false;
  if (new_star_.squared_clearance() < clearance_ * clearance_) return false;
  const double badness = new_star_.badness_in_space();
  if (badness <= bound_) {
    fill(TerrainMetric::surface);
    return true;
  }
  if (!best || badness < best->badness) best = Candidate{p, badness};
  return false;
}

// The worst sample if its star is good in space, else a good place in that star, else the end of
// the LEPP; else whichever of them is best.
bool SurfaceLoop::insert_in_space(TriangleId t, Point p) {
  std::optional<Candidate> best;
  if (try_in_space(t, p, best)) return true;
  if (grow(t, p, TerrainMetric::surface)) {
    new_star_.copy_to(star_, [](Point q) { return q; });
    const SlopeMap slope = slope_of(star_);
    new_star_.copy_to(star_, [&](Point q) { return slope.to_plane(q); });
    if (const auto place = ladder_.front().place.find(star_, slope.to_plane(p))) {
      if (try_in_space(t, snapped(slope.to_plan(*place)), best)) return true;
    }
  }
  const HalfEdge terminal = metric_.terminal_edge(t);
  const Point a = mesh_.point(mesh_.origin(terminal)), b = mesh_.point(mesh_.destination(terminal));
  if (mesh_.is_constrained(terminal)) {
    if (cut(terminal)) return true;
  } else if (try_in_space(terminal.triangle, snapped(midpoint(a, b)), best)) {
    return true;
  }
  if (!best || !grow(t, best->place, TerrainMetric::surface)) return false;
  fill(TerrainMetric::surface);
  return true;
}

bool SurfaceLoop::try_in_plan(TriangleId t, Point p, std::optional<Candidate>& best) {
  if (!grow(t, p, TerrainMetric::planar) || new_star_.encroached()) return false;
  const double badness = new_star_.badness_in_plan();
  if (badness <= bound_) {
    fill(TerrainMetric::planar);
    return true;
  }
  if (!best || badness < best->badness) best = Candidate{p, badness};
  return false;
}

// The same in plan; at last the worst sample itself, whatever its star is like.
bool SurfaceLoop::insert_in_plan(TriangleId t, Point p) {
  std::optional<Candidate> best;
  if (try_in_plan(t, p, best)) return true;
  if (grow(t, p, TerrainMetric::planar)) {
    new_star_.copy_to(star_, [](Point q) { return q; });
    if (const auto place = ladder_.front().place.find(star_, p)) {
      if (try_in_plan(t, snapped(*place), best)) return true;
    }
  }
  const HalfEdge terminal = terminal_edge(mesh_, t);
  const Point a = mesh_.point(mesh_.origin(terminal)), b = mesh_.point(mesh_.destination(terminal));
  const bool is_long = squared_distance(a, b) > 4;
  if (mesh_.is_constrained(terminal)) {
    if (cut(terminal)) return true;
  } else if (is_long && try_in_plan(terminal.triangle, snapped(midpoint(a, b)), best)) {
    return true;
  }
  if (is_long && best && grow(t, best->place, TerrainMetric::planar)) {
    fill(TerrainMetric::planar);
    return true;
  }
  if (!grow(t, p, TerrainMetric::planar)) return false;
  if (const auto e = new_star_.encroached(); e && cut(*e)) return true;
  if (!grow(t, p, TerrainMetric::planar)) return false;
  fill(TerrainMetric::planar);
  return true;
}

void SurfaceLoop::fill(TerrainMetric metric) {
  new_star_.fill(changed_);
  const bool planar = metric == TerrainMetric::planar;
  ++(planar ? untame_ : tame_);
  suspects_.clear();
  for (const TriangleId t : changed_) {
    flips_.set_planar(t, planar);
    for (std::uint32_t i = 0; i < 3; ++i) suspects_.push_back({t, i});
  }
  flips_.restore(suspects_, changed_);
}

// In half, at a sample near there if one is on the edge, or at `at`. Edges that meet others at less
// than 60 degrees are cut as refinement does, so that those are cut alike.
bool SurfaceLoop::cut(HalfEdge e, std::optional<Point> at) {
  if (!terrain_.may_cut(e)) return false;
  const Point a = mesh_.point(mesh_.origin(e)), b = mesh_.point(mesh_.destination(e));
  const bool planar = flips_.is_planar(e.triangle);
  Point p = at.value_or(midpoint(a, b));
  if (!at && !terrain_.is_hard(e) && squared_distance(a, b) >= 9) {
    const Point q = snapped(p);
    if (orient2d(a, b, q) == 0) p = q;
  }
  if (!at && squared_distance(a, b) < 4 * clearance_ * clearance_) return false;
  if (!at && (fan_at(mesh_, e, mesh_.origin(e)).exists() !=
              fan_at(mesh_, e, mesh_.destination(e)).exists())) {
    const auto split = split_constrained_edge(mesh_, e, floor_);
    if (split.vertices.empty()) return false;
    terrain_.add_heights();
    terrain_.rescan(split.changed);
    changed_.insert(changed_.end(), split.changed.begin(), split.changed.end());
  } else {
    const auto q = place_on_chord(mesh_, e, in_supported_range(p));
    if (!q) return false;
    new_star_.cut(e, *q, planar ? TerrainMetric::planar : TerrainMetric::surface, changed_);
  }
  suspects_.clear();
  for (const TriangleId t : changed_) {
    flips_.set_planar(t, planar);
    for (std::uint32_t i = 0; i < 3; ++i) suspects_.push_back({t, i});
  }
  flips_.restore(suspects_, changed_);
  return true;
}

// ---- angles --------------------------------------------------------------------------------

void SurfaceLoop::improve(TriangleId t, Kind kind) {
  if (kind == Kind::plan && flip_in_plan(t)) return;
  for (Rung& rung : ladder_) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (move_corner(t, i, kind, rung)) return;
    }
  }
  if (insert_off_centre(t, kind) || kind == Kind::space) return;
  insert_at_end_of_path(t);
}

// Sets the triangle aside with those around it.
bool SurfaceLoop::flip_in_plan(TriangleId t) {
  const auto before = mesh_.vertices(t);
  suspects_.clear();
  flips_.set_planar(t, true);
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge e{t, i};
    if (mesh_.is_constrained(e)) continue;
    flips_.set_planar(mesh_.twin(e)->triangle, true);
    suspects_.push_back(e);
  }
  flips_.restore(suspects_, changed_);
  return mesh_.vertices(t) != before;
}

SlopeMap SurfaceLoop::slope_of(const Star& star) const {
  std::vector<SpacePoint> chain;
  for (const auto& side : star.link) chain.push_back(metric_.at(mesh_.origin(side.edge)));
  return SlopeMap(chain);
}

// To a place where all angles of the star reach the rung, and the smallest is larger than it was.
bool SurfaceLoop::move_corner(TriangleId t, std::uint32_t corner, Kind kind, Rung& rung) {
  const VertexId v = mesh_.vertex(t, corner);
  if (v.index() < frozen_ || mesh_.origin_of(v).kind != VertexOrigin::Kind::interior) return false;
  if (moves_.size() <= v.index()) moves_.resize(2 * mesh_.vertex_count(), 0);
  if (moves_[v.index()] == most_moves || !find_star(mesh_, t, corner, star_, 12)) return false;
  const double most = worst_of(star_, metric_.at(v), kind);
  Star flat = star_;
  const SlopeMap slope = slope_of(star_);
  const auto there = [&](Point p) { return kind == Kind::space ? slope.to_plane(p) : p; };
  for (auto& side : flat.link) side.from = there(side.from);
  const auto found = rung.place.find(flat, there(mesh_.point(v)));
  if (!found) return false;
  const Point place = kind == Kind::space ? slope.to_plan(*found) : *found;
  const auto is_better = [&](double worst) { return worst <= rung.badness && worst < most; };
  double before = error_;
  for (const auto& side : star_.link) before = std::max(before, terrain_.error(side.edge.triangle));
  for (const Point p : {snapped(place), in_supported_range(place)}) {
    if (!sees_link(star_, p) || !is_better(worst_of(star_, metric_.at(p), kind))) continue;
    if (encroaches(star_, p) || error_of_star(star_, p) > before) continue;
    move(v, p);
    return true;
  }
  return false;
}

void SurfaceLoop::move(VertexId v, Point p) {
  mesh_.move_vertex(v, p);
  terrain_.set_height(v);
  ++moves_[v.index()];
  suspects_.clear();
  for (const auto& side : star_.link) {
    changed_.push_back(side.edge.triangle);
    for (std::uint32_t i = 0; i < 3; ++i) suspects_.push_back({side.edge.triangle, i});
  }
  terrain_.rescan(changed_);
  flips_.restore(suspects_, changed_);
}

// cos^2 of the smallest angle of a star with its center at p, above 1 if one in plan is too small.
double SurfaceLoop::worst_of(const Star& star, const SpacePoint& p, Kind kind) const {
  double worst = 0;
  for (const auto& side : star.link) {
    const SpacePoint a = metric_.at(mesh_.origin(side.edge)),
                     b = metric_.at(mesh_.destination(side.edge));
    const double plan = AngleTest::badness(p.plan(), a.plan(), b.plan());
    if (plan > plan_bound_) worst = std::max(worst, 1 + plan);
    worst = std::max(worst, kind == Kind::plan ? plan : badness(p, a, b));
  }
  return worst;
}

bool SurfaceLoop::encroaches(const Star& star, Point p) const {
  return std::ranges::any_of(star.link, [&](const Star::LinkEdge& side) {
    return side.constrained && would_encroach(mesh_, side.edge, p);
  });
}

double SurfaceLoop::error_of_star(const Star& star, Point p) const {
  const TerrainCorner center = terrain_.space().corner(p, terrain_.height_of(p));
  double worst = 0;
  for (const auto& side : star.link) {
    worst = std::max(worst, terrain_.scan()
                                .worst({center, terrain_.corner(mesh_.origin(side.edge)),
                                        terrain_.corner(mesh_.destination(side.edge))})
                                .error);
  }
  return worst;
}

// An off-centre in the plane of the triangle, if its star is better than what it replaces.
bool SurfaceLoop::insert_off_centre(TriangleId t, Kind kind) {
  const auto metric = kind == Kind::space ? TerrainMetric::surface : TerrainMetric::planar;
  const SlopeMap slope(metric_.corners(t));
  const auto [a, b, c] = mesh_.corners(t);
  const Point p =
      kind == Kind::plan
          ? off_centre_(a, b, c)
          : slope.to_plan(off_centre_(slope.to_plane(a), slope.to_plane(b), slope.to_plane(c)));
  const double before = kind == Kind::plan ? AngleTest::badness(a, b, c) : metric_.badness(t);
  for (const Point q : {snapped(p), in_supported_range(p)}) {
    if (!grow(t, q, metric)) {
      if (barrier_ && kind == Kind::plan) return cut(*barrier_);
      continue;
    }
    if (const auto e = new_star_.encroached()) {
      if (kind == Kind::plan) return cut(*e);
      continue;
    }
    if (new_star_.squared_clearance() < clearance_ * clearance_) continue;
    const double after =
        kind == Kind::plan ? new_star_.badness_in_plan() : new_star_.badness_in_space();
    if (after >= before) continue;
    if (kind == Kind::space && (!new_star_.is_tame() || new_star_.badness_in_plan() > plan_bound_))
      continue;
    fill(metric);
    return true;
  }
  return false;
}

bool SurfaceLoop::insert_at_end_of_path(TriangleId t) {
  const double before =
      AngleTest::badness(mesh_.corners(t)[0], mesh_.corners(t)[1], mesh_.corners(t)[2]);
  const HalfEdge terminal = terminal_edge(mesh_, t);
  if (mesh_.is_constrained(terminal)) return cut(terminal);
  const Point a = mesh_.point(mesh_.origin(terminal)), b = mesh_.point(mesh_.destination(terminal));
  for (const Point q : {snapped(midpoint(a, b)), midpoint(a, b)}) {
    if (!grow(terminal.triangle, q, TerrainMetric::planar) || new_star_.encroached()) continue;
    if (new_star_.squared_clearance() < clearance_ * clearance_) continue;
    if (new_star_.badness_in_plan() >= before) continue;
    fill(TerrainMetric::planar);
    return true;
  }
  return false;
}

Point SurfaceLoop::snapped(Point p) const {
  const Sample s = terrain_.space().nearest(p);
  return std::isnan(terrain_.space().height(s)) ? p : terrain_.space().place(s);
}

}  // namespace lepp
