#include "lepp/refine/unified_loop.hpp"

#include <algorithm>
#include <limits>

#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/refine/straight_walk.hpp"
#include "lepp/triangulation/lepp.hpp"
#include "lepp/triangulation/locate.hpp"
#include "lepp/triangulation/sharp_vertex.hpp"
#include "lepp/triangulation/split.hpp"
#include "lepp/triangulation/split_constrained.hpp"

namespace lepp {

namespace {

// So many triangles of the start are looked at together: their neighbourhood stays in the cache.
constexpr std::size_t seeds_at_once = 16384;

// Cutting a curve changes the angle at which it meets others.
bool has_bent_curves(const Mesh& mesh) {
  return std::ranges::any_of(mesh.entities().curves,
                             [](const CurveEntity& c) { return !is_straight(c.geometry); });
}

}  // namespace

UnifiedLoop::UnifiedLoop(Mesh& mesh, const RefineOptions& options, const LeftAlone& left_alone,
                         std::size_t budget)
    : mesh_(mesh),
      options_(options),
      left_alone_(left_alone),
      floor_(default_size_floor(mesh)),
      allowance_(mesh, options, budget),
      angle_(options.min_angle_deg, options.max_angle_deg),
      off_centre_(options.min_angle_deg),
      good_star_(mesh, options, floor_),
      targets_(mesh, options),
      any_sharp_(segments_meet_sharply(mesh)),
      can_have_fans_(any_sharp_ || has_bent_curves(mesh)) {}

void UnifiedLoop::run() {
  cut_evenly(mesh_, targets_.size(), floor_, [&] { return allowance_.may_go_on(); });
  next_seed_ = 0;
  seeds_ = mesh_.triangle_count();
  if (options_.obtuse == ObtuseRule::split_first) encroached_.emplace(mesh_);
  while (allowance_.may_go_on() && take_turn()) {
    for (const TriangleId t : changed_) targets_.add(mesh_, t);
  }
}

// False if there is nothing left to do.
bool UnifiedLoop::take_turn() {
  changed_.clear();
  if (const auto e = encroached_ ? encroached_->next(mesh_) : std::nullopt) {
    relieve(*e);
  } else if (const auto t = targets_.next(mesh_)) {
    if (is_improvable(*t)) improve(*t);
  } else if (next_seed_ < seeds_) {
    const std::size_t end = std::min(next_seed_ + seeds_at_once, seeds_);
    for (; next_seed_ < end; ++next_seed_) targets_.add(mesh_, TriangleId(next_seed_));
  } else {
    return false;
  }
  return true;
}

// Features of the input below the size floor stay as they are: cutting only spreads them.
void UnifiedLoop::relieve(HalfEdge encroached) {
  if (is_at_feature(encroached.triangle)) return;
  if (angle_.has_largest() && is_obtuse_by_rounding(mesh_, encroached.triangle)) return;
  cut(encroached);
}

bool UnifiedLoop::is_improvable(TriangleId t) const {
  const auto is_on_input = [&](VertexId v) {
    return mesh_.origin_of(v).kind != VertexOrigin::Kind::interior;
  };
  if (std::ranges::count_if(mesh_.vertices(t), is_on_input) < 2) return true;
  if (targets_.is_too_large(t)) return true;
  // What excuses a small angle does not excuse a large one.
  if (targets_.has_large_angle(mesh_, t) && !left_alone_.contains(mesh_, t)) {
    return !is_at_feature(t) && !is_obtuse_by_rounding(mesh_, t);
  }
  return !is_between_constrained(t) && !is_seditious_there(t) && !is_at_feature(t);
}

bool UnifiedLoop::is_between_constrained(TriangleId t) const {
  int constrained = 0;
  for (std::uint32_t i = 0; i < 3; ++i) constrained += mesh_.is_constrained({t, i}) ? 1 : 0;
  return constrained >= 2 && smallest_angle_between_constrained(mesh_, t);
}

bool UnifiedLoop::is_seditious_there(TriangleId t) const {
  return any_sharp_ && shortest_edge_is_seditious(mesh_, t);
}

// The height on the longest edge is the least distance in a triangle.
bool UnifiedLoop::is_at_feature(TriangleId t) const {
  const auto [a, b, c] = mesh_.corners(t);
  const double longest =
      std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
  const double twice_area = cross(b - a, c - a), limit = 2 * floor_;
  if (twice_area * twice_area > 1.01 * limit * limit * longest) return false;
  return at_input_feature(mesh_, t, limit);
}

void UnifiedLoop::improve(TriangleId t) {
  if (move_a_corner(t)) return;
  const auto vertices = mesh_.vertices(t);
  const std::size_t before = mesh_.vertex_count();
  insert_near(t);
  // No new vertex: the size floor. The target is dropped until a neighbour changes.
  if (mesh_.vertex_count() > before && mesh_.vertices(t) == vertices) targets_.add(mesh_, t);
}

bool UnifiedLoop::move_a_corner(TriangleId t) {
  const bool without = options_.effort == Effort::fast && options_.max_angle_deg >= 180;
  if (without || targets_.is_too_large(t)) return false;
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (good_star_.move_corner(t, i, changed_)) return true;
  }
  return false;
}

void UnifiedLoop::insert_near(TriangleId t) {
  const auto [a, b, c] = mesh_.corners(t);
  Point p = off_centre_(a, b, c);
  const bool too_large = targets_.is_too_large(t);
  if (too_large) p = targets_.size_point()(t, p);
  p = in_supported_range(p);
  const bool only_obtuse = !too_large && !targets_.has_small_angle(mesh_, t);
  if ((only_obtuse || options_.placement == Placement::best) && insert_best_of(t, p)) return;
  const WayEnd end = straight_walk(mesh_, t, p);
  if (end.barrier) {
    cut(*end.barrier);
    return;
  }
  if (!contains(mesh_, end.triangle, p)) return;
  const bool possible = cavity_.find(mesh_, end.triangle, p);
  const bool may_be_better = options_.min_angle_deg > 0 && !too_large;
  if (possible && may_be_better && good_star_.insert(cavity_, p, changed_)) return;
  for (const auto& rim : cavity_.rim()) {
    if (rim.constrained && would_encroach(mesh_, rim.inside, p) && cut(rim.inside)) return;
  }
  if (!possible || is_too_close(p)) return;
  fill(p);
}

void UnifiedLoop::fill(Point p) {
  cavity_.fill(mesh_, p, {VertexOrigin::Kind::interior, 0});
  changed_.insert(changed_.end(), cavity_.triangles().begin(), cavity_.triangles().end());
}

// Of the places between off-centre and circumcentre, and at the end of the LEPP, the first with a
// good star, else the one whose worst triangle is best. False if all are barred or encroach.
bool UnifiedLoop::insert_best_of(TriangleId t, Point off_centre) {
  const auto [a, b, c] = mesh_.corners(t);
  const Point center = circumcenter(a, b, c);
  const HalfEdge terminal = terminal_edge(mesh_, t);
  const Point candidates[] = {
      off_centre, center, midpoint(off_centre, center),
      midpoint(mesh_.point(mesh_.origin(terminal)), mesh_.point(mesh_.destination(terminal)))};
  std::optional<Point> best;
  double least = std::numeric_limits<double>::infinity();
  for (const Point candidate : candidates) {
    const Point p = in_supported_range(candidate);
    if (!find_cavity(t, p)) continue;
    if (options_.min_angle_deg > 0 && good_star_.insert(cavity_, p, changed_)) return true;
    const double badness = worst_of_star(p);
    if (badness < least) {
      least = badness;
      best = p;
    }
  }
  if (!best || !find_cavity(t, *best)) return false;
  fill(*best);
  return true;
}

bool UnifiedLoop::find_cavity(TriangleId t, Point p) {
  const WayEnd end = straight_walk(mesh_, t, p);
  return !end.barrier && contains(mesh_, end.triangle, p) && cavity_.find(mesh_, end.triangle, p) &&
         !is_too_close(p);
}

// How bad the worst triangle around p would be, infinite if a constrained edge is encroached.
double UnifiedLoop::worst_of_star(Point p) const {
  double worst = 0;
  const auto rim = cavity_.rim();
  for (std::size_t i = 0; i < rim.size(); ++i) {
    if (rim[i].constrained && would_encroach(mesh_, rim[i].inside, p)) {
      return std::numeric_limits<double>::infinity();
    }
    worst = std::max(worst, angle_.violation(p, rim[i].from, cavity_.to(i)));
  }
  return worst;
}

// Cuts a constrained edge; false if that is not possible.
bool UnifiedLoop::cut(HalfEdge e) {
  const ConstrainedSplit split =
      can_have_fans_ ? split_constrained_edge(mesh_, e, floor_) : split_halfway(mesh_, e, floor_);
  changed_.insert(changed_.end(), split.changed.begin(), split.changed.end());
  if (encroached_) encroached_->update(mesh_, split.changed);
  return !split.vertices.empty();
}

bool UnifiedLoop::is_too_close(Point p) const {
  return std::ranges::any_of(cavity_.rim(), [&](const Cavity::RimEdge& e) {
    return squared_distance(e.from, p) < floor_ * floor_;
  });
}

}  // namespace lepp
