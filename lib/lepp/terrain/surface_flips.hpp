#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lepp/terrain/surface_metric.hpp"
#include "lepp/terrain/surface_report.hpp"
#include "lepp/terrain/terrain_mesh.hpp"

namespace lepp {

/// Which edges the surface metric flips. An edge that breaks the sphere criterion is flipped unless
/// one of the rules of KeptBy keeps it. Triangles can be put aside as planar: their edges follow
/// the circle criterion of the plan, and what a flip joins to them becomes planar, too.
class SurfaceFlips {
 public:
  /// \param plan_angle_deg  a flip after which an angle in plan is below it has to raise the
  ///                        smallest of them
  SurfaceFlips(const SurfaceMetric& metric, TerrainMesh& terrain, double plan_angle_deg);

  /// No flip takes the error of its triangles above this, or above what it was if that is more.
  void set_error(double error) { error_ = error; }

  /// What keeps the diagonal ab of a quadrilateral that breaks the sphere criterion, as far as its
  /// corners tell: `shape` (exact), `angle` or `plan_angle`.
  std::optional<KeptBy> kept_by_corners(const Quad& quad) const;

  bool breaks_sphere(HalfEdge e) const {
    return !terrain_.mesh().is_boundary(e) && lepp::breaks_sphere(metric_.quad(e));
  }
  /// What keeps `e`, which breaks the sphere criterion.
  std::optional<KeptBy> kept_by(HalfEdge e) const;

  bool is_planar(TriangleId t) const { return t.index() < planar_.size() && planar_[t.index()]; }
  void set_planar(TriangleId t, bool planar);
  bool any_planar() const { return !set_aside_.empty(); }
  /// No triangle is planar any more. Appends the edges of those that were.
  void clear_planar(std::vector<HalfEdge>& suspects);

  /// Flips until every edge reachable from `suspects` obeys its criterion, or is kept.
  /// Ends: triangles only become planar; until the next one does, the sorted smallest angles of the
  /// others rise in space, and in plan this is Lawson's algorithm.
  /// \pre the errors of all triangles are known; they are afterwards
  /// \param changed  triangles that a flip touched are appended, with repetitions
  void restore(std::vector<HalfEdge>& suspects, std::vector<TriangleId>& changed);

  /// All edges that break the criterion now, each from its triangle with the lower id.
  std::vector<SphereViolation> violations() const;

 private:
  bool is_to_flip(HalfEdge e) const;
  bool breaks_error(HalfEdge e) const;

  const SurfaceMetric& metric_;
  TerrainMesh& terrain_;
  double plan_badness_;  // cos^2 of the angle in plan
  double error_ = 0;
  std::vector<std::uint8_t> planar_;   // by triangle
  std::vector<TriangleId> set_aside_;  // all that are planar, and some that were
};

}  // namespace lepp
