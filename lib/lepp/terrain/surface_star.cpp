#include "lepp/terrain/surface_star.hpp"

#include <algorithm>
#include <limits>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/encroached.hpp"
#include "lepp/triangulation/flip.hpp"
#include "lepp/triangulation/split.hpp"
#include "lepp/triangulation/split_constrained.hpp"

namespace lepp {

namespace {

constexpr double cos_largest_fold = 0.5;  // 60 degrees

}  // namespace

bool SurfaceStar::grow(TriangleId t, Point p, TerrainMetric metric) {
  kind_ = metric;
  rim_.clear();
  is_tame_ = true;
  longest_ = 0;
  if (!start(t, p)) return false;
  while (!stack_.empty()) {  // ends: the triangles crossed do not overlap in plan
    const HalfEdge e = stack_.back();
    stack_.pop_back();
    if (!is_to_cross(e)) {
      add_to_rim(e);
      continue;
    }
    note_fold(e);
    const HalfEdge f = *terrain_.mesh().twin(e);
    stack_.push_back(previous_edge(f));
    stack_.push_back(next_edge(f));
  }
  judge();
  return clearance() >= same_place * std::min(1.0, terrain_.grid().aspect());
}

// A place on an edge has both of its triangles to start from.
bool SurfaceStar::start(TriangleId t, Point p) {
  const Mesh& mesh = terrain_.mesh();
  start_ = t;
  on_edge_.reset();
  stack_.clear();
  for (const std::uint32_t i : {2U, 1U, 0U}) {
    const HalfEdge e{t, i};
    const double side = orient2d(mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e)), p);
    if (side < 0 || (side == 0 && (on_edge_ || mesh.is_constrained(e)))) return false;
    if (side == 0) {
      on_edge_ = e;
      const HalfEdge f = *mesh.twin(e);
      stack_.push_back(previous_edge(f));
      stack_.push_back(next_edge(f));
    } else {
      stack_.push_back(e);
    }
  }
  place_ = metric_.at(p);
  if (on_edge_) note_fold(*on_edge_);
  return true;
}

bool SurfaceStar::is_to_cross(HalfEdge e) const {
  const Mesh& mesh = terrain_.mesh();
  if (mesh.is_constrained(e)) return false;
  const VertexId a = mesh.origin(e), b = mesh.destination(e), d = mesh.apex(*mesh.twin(e));
  if (kind_ == TerrainMetric::planar) {
    return incircle(place_.plan(), mesh.point(a), mesh.point(b), mesh.point(d)) > 0;
  }
  const Quad quad{metric_.at(a), metric_.at(b), place_, metric_.at(d)};
  return breaks_sphere(quad) && !flips_.kept_by_corners(quad);
}

void SurfaceStar::note_fold(HalfEdge e) {
  longest_ = std::max(longest_, metric_.squared_length(e));
  is_tame_ = is_tame_ && cos_dihedral(metric_.quad(e)) > cos_largest_fold;
}

void SurfaceStar::add_to_rim(HalfEdge e) {
  const Mesh& mesh = terrain_.mesh();
  longest_ = std::max(longest_, metric_.squared_length(e));
  rim_.push_back(
      {e, metric_.at(mesh.origin(e)), metric_.at(mesh.destination(e)), mesh.is_constrained(e)});
}

void SurfaceStar::judge() {
  badness_in_space_ = badness_in_plan_ = 0;
  squared_clearance_ = std::numeric_limits<double>::infinity();
  encroached_.reset();
  const Point p = place_.plan();
  for (const RimEdge& e : rim_) {
    const Point a = e.from.plan(), b = e.to.plan();
    badness_in_space_ = std::max(badness_in_space_, badness(place_, e.from, e.to));
    badness_in_plan_ = std::max(badness_in_plan_, AngleTest::badness(p, a, b));
    squared_clearance_ = std::min(squared_clearance_, squared_distance(p, a));
    is_tame_ = is_tame_ && squared_distance(place_, e.from) < longest_;
    if (e.constrained && !encroached_ && would_encroach(terrain_.mesh(), e.inside, p)) {
      encroached_ = e.inside;
    }
  }
}

void SurfaceStar::fill(std::vector<TriangleId>& changed) {
  Mesh& mesh = terrain_.mesh();
  const VertexOrigin origin{VertexOrigin::Kind::interior, 0};
  stack_.clear();
  const VertexId v = on_edge_ ? split_edge(mesh, *on_edge_, place_.plan(), origin, 0.5, stack_)
                              : split_triangle(mesh, start_, place_.plan(), origin, stack_);
  flip_around(v, changed);
}

void SurfaceStar::cut(HalfEdge e, Point p, TerrainMetric metric, std::vector<TriangleId>& changed) {
  Mesh& mesh = terrain_.mesh();
  kind_ = metric;
  const VertexId from = mesh.origin(e);
  const CurvePiece piece = piece_from(mesh, e, from).piece;
  const Point a = mesh.point(from), b = mesh.point(mesh.destination(e));
  const double part = dot(p - a, b - a) / squared_distance(a, b);
  stack_.clear();
  const VertexId v = split_edge(mesh, e, p, origin_on(mesh, e),
                                piece.t_a + (piece.t_b - piece.t_a) * part, stack_);
  flip_around(v, changed);
}

// The edges opposite v, flipped where is_to_cross() says so.
void SurfaceStar::flip_around(VertexId v, std::vector<TriangleId>& changed) {
  Mesh& mesh = terrain_.mesh();
  const std::size_t first = changed.size();
  terrain_.add_heights();
  place_ = metric_.at(v);
  std::erase_if(stack_, [&](HalfEdge e) { return mesh.apex(e) != v; });
  for (const HalfEdge e : stack_) changed.push_back(e.triangle);
  while (!stack_.empty()) {
    const HalfEdge e = stack_.back();
    stack_.pop_back();
    if (!is_to_cross(e)) continue;
    const TriangleId t = e.triangle, u = mesh.twin(e)->triangle;
    flip(mesh, e);  // v was the apex of e: it is corner 0 of t now, and corner 2 of u
    stack_.push_back({t, 0});
    stack_.push_back({u, 2});
    changed.push_back(u);
  }
  terrain_.rescan(std::span(changed).subspan(first));
}

}  // namespace lepp
