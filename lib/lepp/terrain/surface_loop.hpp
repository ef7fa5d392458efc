#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <queue>
#include <span>

#include "lepp/refine/angle_test.hpp"
#include "lepp/terrain/best_place.hpp"
#include "lepp/terrain/error_heap.hpp"
#include "lepp/terrain/surface_editor.hpp"
#include "lepp/terrain/surface_repair.hpp"
#include "lepp/triangulation/unfinished.hpp"

namespace lepp {

/// Simplification in the metric of space, from a coarse mesh on: LEPP by lengths in space, the
/// sphere criterion, and the metric of the plan where the surface bends too much for them.
/// Between two turns the mesh satisfies M1 to M5, TerrainMesh knows the worst sample of each
/// triangle, and every edge obeys its criterion or is kept by a rule (SurfaceFlips).
class SurfaceLoop {
 public:
  /// \param go_on  asked at each turn; false stops
  SurfaceLoop(TerrainMesh& terrain, double min_angle_deg, std::function<bool()> go_on);

  /// The mesh comes from the planar simplification: what is below the bound in plan, that could
  /// not better, and is no target unless something changes there.
  void take_over(std::span<const Unfinished> unfinished);

  /// Works until every error is at most `error` and no turn betters an angle, or there are
  /// `vertices` vertices.
  /// Ends: samples become vertices once; other places stay a cell away from the corners of their
  /// star, make no edge shorter than there is, or are those of refine(), which are far apart; a
  /// vertex moves only so often; flips between two turns end (SurfaceFlips); and there is a budget,
  /// which no real grid comes near.
  void run(double error, std::size_t vertices);

  /// Vertices that exist now stay where they are from now on.
  void freeze() { repair_.freeze(); }
  double largest_error() const;
  bool cancelled() const { return cancelled_; }
  /// What could not be bettered because a side would have to be cut that is to stay whole.
  const AtKeptBorder& at_kept_border() const { return repair_.at_kept_border(); }
  bool out_of_budget() const {
    return mesh_.vertex_count() >= budget_ || turns_ / turns_per_vertex >= budget_;
  }
  const SurfaceEditor& editor() const { return editor_; }

  /// No flip and no tame insertion makes an angle in plan that is below this: 15 degrees, or the
  /// bound if that is less, but never so small that rounding could fold triangles.
  static double plan_angle_deg(double min_angle_deg) {
    return std::clamp(min_angle_deg, 1.0, largest_plan_angle_deg);
  }
  static constexpr double largest_plan_angle_deg = 15;

 private:
  using Kind = SurfaceRepair::Kind;
  static constexpr std::size_t turns_per_vertex = 100;  // of the budget

  struct Target {
    double badness;
    TriangleId triangle;
    std::array<VertexId, 3> vertices;
    bool operator<(const Target& other) const {
      return badness != other.badness ? badness < other.badness : other.triangle < triangle;
    }
  };
  using Targets = std::priority_queue<Target>;

  void start(double error);
  bool may_go_on();
  bool take_turn();
  void widen(TriangleId t);
  bool flip_back();
  void note_changes();
  void add_if_thin(TriangleId t);
  void add_if_small(TriangleId t);
  std::optional<TriangleId> next(Targets& targets);

  void reduce_error(TriangleId t);
  bool cut_line_at(TriangleId t, Sample s);
  bool insert_in_space(TriangleId t, Point p);
  bool try_in_space(TriangleId t, Point p);
  void insert_in_plan(TriangleId t, Point p);
  bool try_in_plan(TriangleId t, Point p);
  bool take_if_good(Point p, double badness, TerrainMetric metric);
  bool insert_best(TriangleId t, TerrainMetric metric);
  Point middle(HalfEdge e) const;

  TerrainMesh& terrain_;
  const Mesh& mesh_;
  std::function<bool()> go_on_;
  AngleTest angle_, plan_angle_;
  double bound_, plan_bound_;  // cos^2 of the smallest angles in space and in plan
  SurfaceEditor editor_;
  SurfaceRepair repair_;
  std::optional<ErrorHeap> heap_;
  Targets thin_, small_;  // below the bound in plan, and in space
  double error_ = 0;
  std::size_t budget_;  // of vertices
  std::size_t most_vertices_ = 0, turns_ = 0, work_at_flip_ = 0;
  bool cancelled_ = false, is_new_ = true;
  BestPlace best_;  // of the turn in hand
};

}  // namespace lepp
