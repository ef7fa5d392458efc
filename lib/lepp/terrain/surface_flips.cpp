#include "lepp/terrain/surface_flips.hpp"

#include <algorithm>
#include <array>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/flip.hpp"

namespace lepp {

namespace {

// cos^2 of two angles that differ by less may be those of the same one. By less than this no flip
// betters the plan, or else a flip in plan could undo it for ever.
constexpr double rounding = 1e-12;

}  // namespace

std::string to_string(KeptBy rule) {
  switch (rule) {
    case KeptBy::constraint:
      return "constraint";
    case KeptBy::shape:
      return "shape";
    case KeptBy::angle:
      return "angle";
    case KeptBy::plan_angle:
      return "plan_angle";
    case KeptBy::error:
      return "error";
  }
  return {};
}

SurfaceFlips::SurfaceFlips(const SurfaceMetric& metric, TerrainMesh& terrain, double plan_angle_deg)
    : metric_(metric), terrain_(terrain), plan_badness_(AngleTest::squared_cos(plan_angle_deg)) {}

std::optional<KeptBy> SurfaceFlips::kept_by_corners(const Quad& quad) const {
  const auto& [a, b, c, d] = quad;
  const Point p = a.plan(), q = b.plan(), r = c.plan(), s = d.plan();
  if (orient2d(r, p, s) <= 0 || orient2d(s, q, r) <= 0) return KeptBy::shape;
  if (std::max(badness(c, a, d), badness(d, b, c)) >=
      std::max(badness(a, b, c), badness(b, a, d))) {
    return KeptBy::angle;
  }
  const double after = std::max(AngleTest::badness(r, p, s), AngleTest::badness(s, q, r));
  const double before = std::max(AngleTest::badness(p, q, r), AngleTest::badness(q, p, s));
  if (after > plan_badness_ && after >= before - rounding) return KeptBy::plan_angle;
  return std::nullopt;
}

std::optional<KeptBy> SurfaceFlips::kept_by(HalfEdge e) const {
  if (terrain_.mesh().is_constrained(e)) return KeptBy::constraint;
  if (const auto rule = kept_by_corners(metric_.quad(e))) return rule;
  if (breaks_error(e)) return KeptBy::error;
  return std::nullopt;
}

bool SurfaceFlips::breaks_error(HalfEdge e) const {
  const Mesh& mesh = terrain_.mesh();
  const HalfEdge f = *mesh.twin(e);
  const double most = std::max({error_, terrain_.error(e.triangle), terrain_.error(f.triangle)});
  return std::ranges::any_of(terrain_.flipped(e), [&](const TerrainMesh::Seen& t) {
    return !terrain_.scan().is_within(t.corners, most, t.hard);
  });
}

bool SurfaceFlips::is_to_flip(HalfEdge e) const {
  const Mesh& mesh = terrain_.mesh();
  if (mesh.is_constrained(e)) return false;
  const bool planar = is_planar(e.triangle) || is_planar(mesh.twin(e)->triangle);
  if (planar) return !is_locally_delaunay(mesh, e);
  return breaks_sphere(e) && !kept_by(e);
}

void SurfaceFlips::restore(std::vector<HalfEdge>& suspects, std::vector<TriangleId>& changed) {
  while (!suspects.empty()) {
    const HalfEdge e = suspects.back();
    suspects.pop_back();
    if (!is_to_flip(e)) continue;
    const TriangleId t = e.triangle, u = terrain_.mesh().twin(e)->triangle;
    flip(terrain_.mesh(), e);
    const std::array both{t, u};
    if (is_planar(t) || is_planar(u)) {
      for (const TriangleId flipped : both) set_planar(flipped, true);
    }
    terrain_.rescan(both);
    changed.insert(changed.end(), both.begin(), both.end());
    for (const HalfEdge outer : {HalfEdge{t, 0}, HalfEdge{t, 2}, HalfEdge{u, 0}, HalfEdge{u, 2}}) {
      suspects.push_back(outer);
    }
  }
}

void SurfaceFlips::set_planar(TriangleId t, bool planar) {
  if (planar == is_planar(t)) return;
  if (planar_.size() <= t.index()) planar_.resize(2 * t.index() + 1, 0);
  planar_[t.index()] = planar ? 1 : 0;
  if (planar) set_aside_.push_back(t);
}

void SurfaceFlips::clear_planar(std::vector<HalfEdge>& suspects) {
  for (const TriangleId t : set_aside_) {
    if (!is_planar(t)) continue;
    planar_[t.index()] = 0;
    for (std::uint32_t i = 0; i < 3; ++i) suspects.push_back({t, i});
  }
  set_aside_.clear();
}

std::vector<SphereViolation> SurfaceFlips::violations() const {
  const Mesh& mesh = terrain_.mesh();
  std::vector<SphereViolation> all;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      const auto f = mesh.twin(e);
      if (!f || f->triangle < e.triangle || !breaks_sphere(e)) continue;
      if (const auto rule = kept_by(e)) all.push_back({e, *rule});
    }
  }
  return all;
}

}  // namespace lepp
