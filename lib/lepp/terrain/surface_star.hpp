#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "lepp/terrain/simplify.hpp"
#include "lepp/terrain/surface_flips.hpp"
#include "lepp/triangulation/relocate.hpp"

namespace lepp {

/// The star that a vertex at some place would get, by the metric of space or of the plan: from the
/// triangle that contains the place it grows across each edge that the new vertex and the vertex
/// beyond call for flipping. In the plane this is the cavity of the place (cavity.hpp); in space it
/// stays star-shaped in plan because only strictly convex quadrilaterals are flipped.
///
/// Growing tells what the star would be like, so that places can be compared before the mesh is
/// touched; fill() does the same flips on the mesh. Keeps its memory.
class SurfaceStar {
 public:
  struct RimEdge {
    HalfEdge inside;  ///< seen from the star
    SpacePoint from, to;
    bool constrained;
  };

  SurfaceStar(const SurfaceMetric& metric, const SurfaceFlips& flips, TerrainMesh& terrain)
      : metric_(metric), flips_(flips), terrain_(terrain) {}

  /// \pre `p` lies in the closed triangle t
  /// \return false if no vertex can be put there: one is there up to rounding, or a constrained
  ///         edge
  bool grow(TriangleId t, Point p, TerrainMetric metric);

  const std::vector<RimEdge>& rim() const { return rim_; }
  /// cos^2 of the smallest angle of the star, in space and in plan.
  double badness_in_space() const { return badness_in_space_; }
  double badness_in_plan() const { return badness_in_plan_; }
  /// Distance in plan to the nearest vertex of the rim.
  double clearance() const { return std::sqrt(squared_clearance_); }
  /// A constrained edge of the rim that would see the place under more than 90 degrees in plan.
  std::optional<HalfEdge> encroached() const { return encroached_; }
  /// True if the star suits the metric of space: what it replaces folds by less than 60 degrees
  /// along each edge inside, and each new edge is shorter than the longest edge replaced or
  /// kept on the rim.
  bool is_tame() const { return is_tame_; }

  /// The rim as the star of a vertex to be.
  void copy_to(Star& star) const {
    star.link.clear();
    for (const RimEdge& e : rim_) {
      star.link.push_back({e.inside, e.from.plan(), e.constrained});
    }
  }

  /// Makes the vertex: the star as it was found. Heights and errors are up to date afterwards.
  /// \pre grow() returned true, nothing changed since
  /// \param changed  gets the triangles of the star, with repetitions
  void fill(std::vector<TriangleId>& changed);

  /// Cuts constrained edge `e` at `p`, and flips around the new vertex likewise.
  /// \pre can_split_edge(mesh, e, p)
  void cut(HalfEdge e, Point p, TerrainMetric metric, std::vector<TriangleId>& changed);

 private:
  bool start(TriangleId t, Point p);
  bool is_to_cross(HalfEdge e) const;
  void add_to_rim(HalfEdge e);
  void judge();
  void note_fold(HalfEdge e);
  void flip_around(VertexId v, std::vector<TriangleId>& changed);

  const SurfaceMetric& metric_;
  const SurfaceFlips& flips_;
  TerrainMesh& terrain_;
  TerrainMetric kind_ = TerrainMetric::surface;
  SpacePoint place_;
  TriangleId start_;
  std::optional<HalfEdge> on_edge_;
  std::vector<RimEdge> rim_;
  double badness_in_space_ = 0, badness_in_plan_ = 0;
  double squared_clearance_ = 0, longest_ = 0;
  std::optional<HalfEdge> encroached_;
  bool is_tame_ = false;
  std::vector<HalfEdge> stack_;
};

}  // namespace lepp
