#include "lepp/refine/good_star.hpp"

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/encroached.hpp"
#include "lepp/triangulation/flip.hpp"
#include "lepp/triangulation/split.hpp"

namespace lepp {

namespace {

// One move may undo another, so that only a limit makes an end certain; few get near it.
constexpr std::uint8_t most_moves = 20;

}  // namespace

GoodStar::GoodStar(Mesh& mesh, const RefineOptions& options, double floor)
    : mesh_(mesh),
      floor_(floor),
      encroaching_allowed_(options.obtuse == ObtuseRule::ignore),
      angle_(options.min_angle_deg),
      place_(options.min_angle_deg) {}

bool GoodStar::move_corner(TriangleId t, std::uint32_t corner, std::vector<TriangleId>& changed) {
  const VertexId v = mesh_.vertex(t, corner);
  if (mesh_.origin_of(v).kind != VertexOrigin::Kind::interior) return false;
  if (moves_.size() <= v.index()) moves_.resize(2 * mesh_.vertex_count(), 0);
  if (moves_[v.index()] == most_moves || !find_star(mesh_, t, corner, star_)) return false;
  const auto place = place_.find(star_, mesh_.point(v));
  if (!place) return false;
  const Point p = in_supported_range(*place);
  if (!is_good(p) || encroaches_beyond_link(p)) return false;
  move_vertex(mesh_, v, star_, p, changed);
  ++moves_[v.index()];
  return true;
}

bool GoodStar::insert(Cavity& cavity, Point p, std::vector<TriangleId>& changed) {
  star_.clear();
  for (const auto& rim : cavity.rim()) star_.add(mesh_, rim.inside);
  const auto place = place_.find(star_, p);
  if (!place) return false;
  const Point q = in_supported_range(*place);
  if (!is_good(q) || encroaches_beyond_link(q)) return false;
  cavity.fill(mesh_, q, {VertexOrigin::Kind::interior, 0});
  std::vector<HalfEdge> suspects;
  for (const TriangleId t : cavity.triangles()) {
    changed.push_back(t);
    suspects.push_back({t, 0});
    suspects.push_back({t, 1});  // one spoke of each triangle
  }
  restore_delaunay(mesh_, suspects, &changed);
  return true;
}

bool GoodStar::is_good(Point p) const {
  if (!sees_link(star_, p)) return false;
  for (std::size_t i = 0; i < star_.size(); ++i) {
    const Point a = star_.from(i), b = star_.to(i);
    if (angle_.is_below(p, a, b) || squared_distance(a, p) < floor_ * floor_) return false;
  }
  return true;
}

// Flips will join p to what lies beyond the link, as far as circumcircles hold p.
bool GoodStar::encroaches_beyond_link(Point p) {
  if (encroaching_allowed_) return false;
  stack_.assign(star_.link.begin(), star_.link.end());
  std::size_t left = mesh_.triangle_count();
  while (!stack_.empty()) {  // ends: by `left`, long before by the tree that cavities are
    const HalfEdge e = stack_.back();
    stack_.pop_back();
    if (mesh_.is_constrained(e)) {
      if (would_encroach(mesh_, e, p)) return true;
      continue;
    }
    const HalfEdge f = *mesh_.twin(e);
    const auto [a, b, c] = mesh_.corners(f.triangle);
    if (incircle(a, b, c, p) <= 0) continue;
    if (left-- == 0) return true;
    stack_.push_back(previous_edge(f));
    stack_.push_back(next_edge(f));
  }
  return false;
}

}  // namespace lepp
