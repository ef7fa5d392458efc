#include "lepp/terrain/surface_editor.hpp"

#include <algorithm>

#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/refine/straight_walk.hpp"
#include "lepp/triangulation/locate.hpp"
#include "lepp/triangulation/sharp_vertex.hpp"
#include "lepp/triangulation/split.hpp"
#include "lepp/triangulation/split_constrained.hpp"
#include "lepp/triangulation/unfinished.hpp"

namespace lepp {

namespace {

double squared_distance_to_segment(Point p, Point a, Point b) {
  const double part = std::clamp(dot(p - a, b - a) / squared_distance(a, b), 0.0, 1.0);
  return squared_distance(p, a + part * (b - a));
}

}  // namespace

SurfaceEditor::SurfaceEditor(TerrainMesh& terrain, double plan_angle_deg)
    : terrain_(terrain),
      mesh_(terrain.mesh()),
      metric_(terrain),
      flips_(metric_, terrain, plan_angle_deg),
      star_(metric_, flips_, terrain),
      clearance_((1 - same_place) * std::min(1.0, terrain.grid().aspect())),
      floor_(default_size_floor(mesh_)) {}

std::span<const TriangleId> SurfaceEditor::changed() {
  std::ranges::sort(changed_);
  changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
  return changed_;
}

bool SurfaceEditor::grow(TriangleId t, Point p, TerrainMetric metric) {
  const WayEnd end = straight_walk(mesh_, t, p);
  barrier_ = end.barrier;
  return !end.barrier && contains(mesh_, end.triangle, p) && star_.grow(end.triangle, p, metric);
}

void SurfaceEditor::fill(TerrainMetric metric) {
  const bool planar = metric == TerrainMetric::planar;
  now_.clear();
  star_.fill(now_);
  ++(planar ? untame_ : tame_);
  settle(planar);
}

bool SurfaceEditor::cut(HalfEdge e, double least) {
  const Point a = mesh_.point(mesh_.origin(e)), b = mesh_.point(mesh_.destination(e));
  if (!terrain_.may_cut_with_fan(e) || squared_distance(a, b) < 4 * least * least) return false;
  const VertexId from = mesh_.origin(e), to = mesh_.destination(e);
  const bool fan_at_a = fan_at(mesh_, e, from).exists(), fan_at_b = fan_at(mesh_, e, to).exists();
  if (fan_at_a != fan_at_b) return split_with_fan(e, fan_at_a ? from : to);
  const auto sample = terrain_.is_hard(e) ? std::nullopt : terrain_.sample_inside(e, 0.5);
  return split(e, sample.value_or(midpoint(a, b)));
}

bool SurfaceEditor::cut_at(HalfEdge e, Point p) { return terrain_.may_cut(e) && split(e, p); }

bool SurfaceEditor::split(HalfEdge e, Point p) {
  const auto q = point_near_chord(mesh_, e, in_supported_range(p),
                                  [&](Point r) { return can_split_edge(mesh_, e, r); });
  if (!q) return false;
  const bool planar = flips_.is_planar(e.triangle);
  now_.clear();
  star_.cut(e, *q, planar ? TerrainMetric::planar : TerrainMetric::surface, now_);
  settle(planar);
  return true;
}

bool SurfaceEditor::split_with_fan(HalfEdge e, VertexId center) {
  if (mesh_.vertex_count() + fan_at(mesh_, e, center).edges.size() > most_vertices_) return false;
  const bool planar = flips_.is_planar(e.triangle);
  const ConstrainedSplit split = split_constrained_edge(mesh_, e, floor_);
  if (split.vertices.empty()) return false;
  terrain_.add_heights();
  terrain_.rescan(split.changed);
  now_ = split.changed;
  settle(planar);
  return true;
}

void SurfaceEditor::move(VertexId v, const Star& star, Point p) {
  mesh_.move_vertex(v, p);
  terrain_.set_height(v);
  ++moves_;
  now_.clear();
  for (const auto& side : star.link) now_.push_back(side.edge.triangle);
  terrain_.rescan(now_);
  suspects_.clear();
  for (const TriangleId t : now_) {
    for (std::uint32_t i = 0; i < 3; ++i) suspects_.push_back({t, i});
  }
  changed_.insert(changed_.end(), now_.begin(), now_.end());
  flips_.restore(suspects_, changed_);
}

// The triangles that changed now belong to one metric.
void SurfaceEditor::settle(bool planar) {
  suspects_.clear();
  for (const TriangleId t : now_) {
    flips_.set_planar(t, planar);
    for (std::uint32_t i = 0; i < 3; ++i) suspects_.push_back({t, i});
  }
  changed_.insert(changed_.end(), now_.begin(), now_.end());
  flips_.restore(suspects_, changed_);
}

bool SurfaceEditor::flip_in_plan(TriangleId t) {
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

bool SurfaceEditor::lay_flat_around(TriangleId t) {
  const auto before = mesh_.vertices(t);
  while (mesh_.vertices(t) == before) {  // ends: more triangles are aside each time
    suspects_.clear();
    set_circle_aside(t);
    if (suspects_.empty()) return false;
    flips_.restore(suspects_, changed_);
  }
  return true;
}

// From `t` across all edges that come nearer to the center than the radius. The edges of what was
// not aside become suspects.
void SurfaceEditor::set_circle_aside(TriangleId t) {
  const auto [a, b, c] = mesh_.corners(t);
  const Point center = circumcenter(a, b, c);
  const double squared_radius = squared_distance(center, a);
  round_of_.resize(mesh_.triangle_count(), 0);
  ++round_;
  in_circle_.assign(1, t);
  round_of_[t.index()] = round_;
  for (std::size_t k = 0; k < in_circle_.size(); ++k) {
    const TriangleId in = in_circle_[k];
    const bool is_new = !flips_.is_planar(in);
    flips_.set_planar(in, true);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{in, i};
      if (mesh_.is_constrained(e)) continue;
      if (is_new) suspects_.push_back(e);
      const TriangleId beyond = mesh_.twin(e)->triangle;
      const double near = squared_distance_to_segment(center, mesh_.point(mesh_.origin(e)),
                                                      mesh_.point(mesh_.destination(e)));
      if (round_of_[beyond.index()] == round_ || !(near < squared_radius)) continue;
      round_of_[beyond.index()] = round_;
      in_circle_.push_back(beyond);
    }
  }
}

void SurfaceEditor::flip_everywhere() {
  suspects_.clear();
  for (std::size_t t = mesh_.triangle_count(); t-- > 0;) {
    for (std::uint32_t i = 0; i < 3; ++i) suspects_.push_back({TriangleId(t), i});
  }
  flips_.restore(suspects_, changed_);
}

void SurfaceEditor::flip_planar_back() {
  suspects_.clear();
  flips_.clear_planar(suspects_);
  flips_.restore(suspects_, changed_);
}

}  // namespace lepp
