#include "lepp/triangulation/encroached.hpp"

#include <algorithm>
#include <unordered_set>

#include "lepp/geometry/predicates.hpp"

namespace lepp {

bool would_encroach(const Mesh& mesh, HalfEdge e, Point p) {
  return is_obtuse(mesh.point(mesh.origin(e)), p, mesh.point(mesh.destination(e)));
}

bool faces_obtuse_angle(const Mesh& mesh, HalfEdge e) {
  return would_encroach(mesh, e, mesh.point(mesh.apex(e)));
}

bool is_encroached(const Mesh& mesh, HalfEdge e) {
  if (faces_obtuse_angle(mesh, e)) return true;
  const auto across = mesh.twin(e);
  return across && faces_obtuse_angle(mesh, *across);
}

std::vector<HalfEdge> edges_encroached_by(const Mesh& mesh, TriangleId t, Point p) {
  // The cavity of p: triangles whose circumcircle holds p, reached without crossing a constrained
  // edge. Its rim edges and p make the triangles that the insertion leaves.
  std::vector<TriangleId> cavity{t};
  std::unordered_set<TriangleId> known;  // the cavity, once it is large
  const auto is_in_cavity = [&](TriangleId next) {
    constexpr std::size_t few = 32;
    if (cavity.size() <= few) return std::ranges::find(cavity, next) != cavity.end();
    if (known.empty()) known.insert(cavity.begin(), cavity.end());
    return known.contains(next);
  };
  std::vector<HalfEdge> encroached;
  for (std::size_t i = 0; i < cavity.size(); ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdge e{cavity[i], k};
      if (mesh.is_constrained(e)) {
        if (would_encroach(mesh, e, p)) encroached.push_back(e);
        continue;
      }
      const TriangleId next = mesh.twin(e)->triangle;
      if (is_in_cavity(next)) continue;
      const auto [a, b, c] = mesh.corners(next);
      if (incircle(a, b, c, p) <= 0) continue;
      cavity.push_back(next);
      if (!known.empty()) known.insert(next);
    }
  }
  return encroached;
}

EncroachedEdges::EncroachedEdges(const Mesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) add(mesh, TriangleId(t));
}

void EncroachedEdges::update(const Mesh& mesh, const std::vector<TriangleId>& changed) {
  for (const TriangleId t : changed) add(mesh, t);
}

void EncroachedEdges::add(const Mesh& mesh, TriangleId t) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge e{t, i};
    if (mesh.is_constrained(e) && faces_obtuse_angle(mesh, e)) {
      entries_.push_back({mesh.origin(e), mesh.destination(e), t});
    }
  }
}

std::optional<HalfEdge> EncroachedEdges::next(const Mesh& mesh) {
  while (first_ < entries_.size()) {
    const Entry entry = entries_[first_++];
    if (first_ > 1024 && 2 * first_ > entries_.size()) {
      entries_.erase(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(first_));
      first_ = 0;
    }
    // An obtuse apex that is gone from this triangle was queued again where it went.
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{entry.triangle, i};
      if (mesh.origin(e) == entry.a && mesh.destination(e) == entry.b &&
          faces_obtuse_angle(mesh, e)) {
        return e;
      }
    }
  }
  return std::nullopt;
}

}  // namespace lepp
