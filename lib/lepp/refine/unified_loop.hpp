#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lepp/refine/allowance.hpp"
#include "lepp/refine/good_star.hpp"
#include "lepp/refine/left_alone.hpp"
#include "lepp/refine/off_centre.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/refine/target_buckets.hpp"
#include "lepp/triangulation/cavity.hpp"
#include "lepp/triangulation/encroached.hpp"

namespace lepp {

/// The loop behind refine() with off-centres. Encroached edges first; then, for each target:
///   1. a corner of it is moved to where all triangles around it are good, if there is such a place
///      (not with Effort::fast);
///   2. else a vertex is inserted in the cavity of its off-centre where all new triangles are good;
///   3. else at the off-centre, unless that encroaches a constrained edge: then that edge is cut.
class UnifiedLoop {
 public:
  UnifiedLoop(Mesh& mesh, const RefineOptions& options, const LeftAlone& left_alone,
              std::size_t budget);

  /// Works on every triangle. Between two turns the mesh satisfies M1 to M6. Ends: each turn adds a
  /// vertex, of which there are at most `budget`, moves one, which each may only so often, or
  /// drops an entry for good.
  void run();

  /// Why it stopped before the work was done, if it did.
  std::optional<Reason> stopped() const { return allowance_.stopped(); }

 private:
  bool take_turn();
  bool is_improvable(TriangleId t) const;
  bool is_between_constrained(TriangleId t) const;
  bool is_seditious_there(TriangleId t) const;
  bool is_at_feature(TriangleId t) const;
  void relieve(HalfEdge encroached);
  void improve(TriangleId t);
  bool move_a_corner(TriangleId t);
  void insert_near(TriangleId t);
  bool cut(HalfEdge e);
  bool is_too_close(Point p) const;
  void fill(Point p);
  bool insert_best_of(TriangleId t, Point off_centre);
  bool find_cavity(TriangleId t, Point p);
  double worst_of_star(Point p) const;

  Mesh& mesh_;
  const RefineOptions& options_;
  const LeftAlone& left_alone_;
  double floor_;
  Allowance allowance_;
  AngleTest angle_;
  OffCentre off_centre_;
  GoodStar good_star_;
  TargetBuckets targets_;
  bool any_sharp_;      // without sharp vertices nothing is seditious
  bool can_have_fans_;  // constrained edges that are cut at common radii
  std::optional<EncroachedEdges> encroached_;
  std::size_t next_seed_ = 0, seeds_ = 0;  // triangles of the start not yet looked at
  Cavity cavity_;
  std::vector<TriangleId> changed_;
};

}  // namespace lepp
