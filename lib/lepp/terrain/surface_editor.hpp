#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "lepp/terrain/surface_flips.hpp"
#include "lepp/terrain/surface_star.hpp"
#include "lepp/terrain/terrain_mesh.hpp"
#include "lepp/triangulation/relocate.hpp"

namespace lepp {

/// Changes a TIN by the surface metric: each change is followed by flips until every edge obeys its
/// criterion or is kept (SurfaceFlips), and leaves M1 to M5 and the errors of all triangles true.
class SurfaceEditor {
 public:
  SurfaceEditor(TerrainMesh& terrain, double plan_angle_deg);
  SurfaceEditor(const SurfaceEditor&) = delete;  // its parts refer to each other
  SurfaceEditor& operator=(const SurfaceEditor&) = delete;

  TerrainMesh& terrain() { return terrain_; }
  const Mesh& mesh() const { return mesh_; }
  const SurfaceMetric& metric() const { return metric_; }
  SurfaceFlips& flips() { return flips_; }
  const SurfaceFlips& flips() const { return flips_; }

  /// Triangles that changed since forget(), ascending, without repetitions.
  std::span<const TriangleId> changed();
  bool has_changed() const { return !changed_.empty(); }
  void forget() { changed_.clear(); }

  /// Walks from `t` to `p` and grows its star() there.
  /// \return false if no vertex can be put there, or a constrained edge bars the way: barrier()
  bool grow(TriangleId t, Point p, TerrainMetric metric);
  const SurfaceStar& star() const { return star_; }
  std::optional<HalfEdge> barrier() const { return barrier_; }
  /// Puts a vertex where grow() was last, and its triangles aside if `metric` is planar.
  void fill(TerrainMetric metric);

  /// Cuts constrained edge `e` in half, at a sample near there if one is on it. An edge that meets
  /// another below 60 degrees is cut as refinement does, so that the other is cut alike.
  /// \return false if it may not be cut, parts would be shorter than `least`, or there would be too
  ///         many vertices
  bool cut(HalfEdge e, double least);
  /// Cuts it at `p`, a place on it up to rounding.
  bool cut_at(HalfEdge e, Point p);

  /// Moves `v`, the center of `star`. \pre sees_link(star, p)
  void move(VertexId v, const Star& star, Point p);
  /// Puts `t` and its neighbours aside. \return true if that flips `t` away
  bool flip_in_plan(TriangleId t);
  /// Puts all triangles aside that reach into the circumcircle of `t`, until it holds no vertex:
  /// then refinement in plan ends as in a Delaunay mesh. \return true if that flips `t` away
  bool lay_flat_around(TriangleId t);
  void flip_everywhere();
  /// What was put aside goes back to the metric of space.
  void flip_planar_back();

  /// No cut of several edges at once makes more vertices than this.
  void set_most_vertices(std::size_t most) { most_vertices_ = most; }

  /// How far vertices that no sample asks for stay from others: a cell, a trifle less.
  double clearance() const { return clearance_; }
  /// The shortest edge that makes sense in these coordinates.
  double floor() const { return floor_; }

  std::size_t moves() const { return moves_; }
  std::size_t tame() const { return tame_; }
  std::size_t untame() const { return untame_; }

 private:
  bool split(HalfEdge e, Point p);
  bool split_with_fan(HalfEdge e, VertexId center);
  void settle(bool planar);
  void set_circle_aside(TriangleId t);

  TerrainMesh& terrain_;
  Mesh& mesh_;
  SurfaceMetric metric_;
  SurfaceFlips flips_;
  SurfaceStar star_;
  double clearance_, floor_;
  std::size_t most_vertices_ = std::numeric_limits<std::size_t>::max();
  std::size_t moves_ = 0, tame_ = 0, untame_ = 0;
  std::optional<HalfEdge> barrier_;
  std::vector<TriangleId> changed_;
  std::vector<TriangleId> now_;  // changed by the operation in hand
  std::vector<HalfEdge> suspects_;
  std::vector<TriangleId> in_circle_;
  std::vector<std::uint32_t> round_of_;  // by triangle: when it was in a circle
  std::uint32_t round_ = 0;
};

}  // namespace lepp
