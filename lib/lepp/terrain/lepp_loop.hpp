#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "lepp/refine/angle_test.hpp"
#include "lepp/refine/feasible_place.hpp"
#include "lepp/refine/off_centre.hpp"
#include "lepp/refine/target_buckets.hpp"
#include "lepp/terrain/best_place.hpp"
#include "lepp/terrain/error_heap.hpp"
#include "lepp/terrain/free_stars.hpp"
#include "lepp/terrain/small_angles.hpp"
#include "lepp/terrain/terrain_mesh.hpp"
#include "lepp/triangulation/encroached.hpp"
#include "lepp/triangulation/relocate.hpp"

namespace lepp {

/// Inserts vertices until both bounds hold. Between two turns the mesh satisfies M1 to M6, and
/// TerrainMesh knows the worst sample of each triangle. A turn takes a triangle with an angle below
/// the bound, or else the one that is off most, finds its place by its LEPP, its cavity or a star,
/// and prefers places where all new angles reach the bound; samples before places between them.
class LeppLoop {
 public:
  /// \param go_on  asked at each turn; false stops
  LeppLoop(TerrainMesh& terrain, double min_angle_deg, std::function<bool()> go_on);

  /// Works until every error is at most `error` and every angle that can be bettered reaches the
  /// bound. With `vertices` it ends with at most so many, at the least error that it came by; with
  /// small angles left if those alone would take more, and at once if there are more.
  /// Ends: samples become vertices once; other places are those of refine(), which are far apart;
  /// a vertex may move only so often; and there is a budget.
  void run(double error, std::size_t vertices);

  /// Vertices that exist now stay where they are from now on.
  void freeze() { free_stars_.freeze(); }
  std::size_t frozen() const { return free_stars_.frozen(); }
  /// The largest error, or the bound of run() if what is above it cannot be mended.
  double largest_error() const;
  /// What the last run() gave up.
  const AtKeptBorder& at_kept_border() const { return at_kept_border_; }
  bool cancelled() const { return cancelled_; }
  /// True if the last run() left small angles for want of vertices.
  bool limited() const { return limited_; }
  bool out_of_budget() const { return mesh_.vertex_count() >= budget_; }

 private:
  void start();
  bool may_go_on();
  bool take_turn(std::size_t vertices);
  void note_changes();
  void keep_if_best(std::size_t vertices);
  void keep_within(std::size_t vertices);

  bool improve(TriangleId t);
  bool move_a_corner(TriangleId t);
  bool is_good_center(Point p) const;
  bool insert_at_good_place(TriangleId t, Point p);
  bool insert_or_cut(TriangleId t, Point p);

  void reduce_error(TriangleId t);
  bool cut_line_at(TriangleId t, Sample s);
  bool insert_if_good(TriangleId t, Point p);
  bool fill_if_good(Point p);
  bool insert_near_worst(TriangleId t, Point p);
  bool insert_at_end_of_path(HalfEdge terminal);
  bool insert_best(TriangleId t);

  bool find_cavity(TriangleId t, Point p);
  bool is_at_vertex(Point p) const;
  std::optional<Point> good_place_in_cavity(Point near);
  std::optional<HalfEdge> encroached_by(Point p) const;
  double badness_of_star(Point p) const;
  void fill(Point p);
  bool cut(HalfEdge e);
  bool give_up_at_border();
  bool cut_at_sample_near(HalfEdge e, Point p);
  bool is_sharp(HalfEdge e) const;
  double squared_length(HalfEdge e) const;

  TerrainMesh& terrain_;
  Mesh& mesh_;
  std::function<bool()> go_on_;
  AngleTest angle_;
  double bound_;  // cos^2 of the smallest angle
  OffCentre off_centre_;
  FeasiblePlace place_;
  RefineOptions asked_;
  std::optional<TargetBuckets> targets_;
  std::optional<ErrorHeap> heap_;
  double error_ = 0;
  double floor_;
  bool any_sharp_;
  std::optional<EncroachedEdges> encroached_;  // looked at only where lines meet sharply
  std::size_t budget_;
  bool cancelled_ = false;

  std::optional<TerrainMesh::State> kept_;  // the least error with so many vertices
  double kept_error_ = std::numeric_limits<double>::infinity();
  std::optional<TerrainMesh::State> within_;  // the most vertices that there may be, or a few less
  bool limited_ = false;

  AtKeptBorder at_kept_border_;
  FreeStars free_stars_;

  // Of the turn in hand.
  std::optional<TriangleId> target_;
  Cavity cavity_;
  std::optional<HalfEdge> barrier_;  // what kept find_cavity() from its place
  Star star_;
  BestPlace best_;
  std::vector<TriangleId> changed_;
  std::vector<HalfEdge> suspects_;
};

}  // namespace lepp
