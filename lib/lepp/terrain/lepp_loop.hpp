#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lepp/refine/angle_test.hpp"
#include "lepp/refine/feasible_place.hpp"
#include "lepp/refine/off_centre.hpp"
#include "lepp/refine/target_buckets.hpp"
#include "lepp/terrain/error_heap.hpp"
#include "lepp/terrain/simplify.hpp"
#include "lepp/terrain/terrain_mesh.hpp"
#include "lepp/triangulation/relocate.hpp"

namespace lepp {

/// Simplification with angles in mind. Between two turns the mesh satisfies M1 to M6, and
/// TerrainMesh knows the worst sample of each triangle. A turn takes a triangle with an angle below
/// the bound, or else the one that is off most.
class LeppLoop {
 public:
  LeppLoop(const HeightGrid& grid, TerrainMesh& terrain, const SimplifyOptions& options);

  /// Works until every error is at most `error`, every angle but those that cannot be bettered
  /// reaches the bound, or there are `vertices` vertices.
  void run(double error, std::size_t vertices);

  /// Vertices that exist now stay where they are from now on.
  bool freeze() {
    frozen_ = mesh_.vertex_count();
    return true;
  }
  double largest_error() const;

 private:
  // A place for a vertex, and the worst angle of the star it would get.
  struct Candidate {
    Point place;
    double badness;
  };

  bool take_turn();
  void note_changes();
  bool is_improvable(TriangleId t) const;
  bool improve(TriangleId t);
  void reduce_error(TriangleId t);
  bool move_a_corner(TriangleId t);
  bool move_corner(TriangleId t, std::uint32_t corner);
  bool insert_near(TriangleId t, Point p);
  bool find_cavity(TriangleId t, Point p);
  std::optional<HalfEdge> encroached_by(Point p) const;
  double badness_of_star(Point p) const;
  void fill(Point p);
  bool cut(HalfEdge e);
  bool cut_near(HalfEdge e, Point p);
  Point snapped(Point p) const;
  double error_of_star(const Star& star, Point p) const;

  const HeightGrid& grid_;
  TerrainMesh& terrain_;
  Mesh& mesh_;
  AngleTest angle_;
  double bound_;  // cos^2 of the smallest angle
  OffCentre off_centre_;
  FeasiblePlace place_;
  RefineOptions target_options_;
  std::optional<TargetBuckets> targets_;
  std::optional<ErrorHeap> heap_;
  double error_ = 0;
  std::size_t most_vertices_ = 0, frozen_ = 0;
  double floor_;
  Cavity cavity_;
  Star star_;
  std::optional<HalfEdge> barrier_;
  std::vector<std::uint8_t> moves_;
  std::vector<TriangleId> changed_;
  std::vector<HalfEdge> stack_;
};

}  // namespace lepp
