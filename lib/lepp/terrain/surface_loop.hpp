#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <queue>
#include <vector>

#include "lepp/refine/angle_test.hpp"
#include "lepp/refine/feasible_place.hpp"
#include "lepp/refine/off_centre.hpp"
#include "lepp/terrain/error_heap.hpp"
#include "lepp/terrain/surface_flips.hpp"
#include "lepp/terrain/surface_star.hpp"
#include "lepp/terrain/terrain_mesh.hpp"
#include "lepp/triangulation/relocate.hpp"

namespace lepp {

/// Simplification in the metric of space, from a coarse mesh on: LEPP by lengths in space, the
/// sphere criterion, and the metric of the plan where the surface bends too much for them.
/// Between two turns the mesh satisfies M1 to M5, TerrainMesh knows the worst sample of each
/// triangle, and every edge obeys its criterion or is kept by a rule (SurfaceFlips).
class SurfaceLoop {
 public:
  /// \param go_on  asked now and then; false stops
  SurfaceLoop(const HeightGrid& grid, TerrainMesh& terrain, double min_angle_deg,
              std::function<bool()> go_on);

  /// Works until every error is at most `error` and no turn betters an angle, or there are
  /// `vertices` vertices.
  /// Ends: samples become vertices once, other places stay a cell away from the corners of their
  /// star, a vertex moves only so often, flips between two turns end (SurfaceFlips), and there is a
  /// budget, which no real grid comes near.
  void run(double error, std::size_t vertices);

  /// Vertices that exist now stay where they are from now on.
  void freeze() { frozen_ = mesh_.vertex_count(); }
  double largest_error() const;
  bool cancelled() const { return cancelled_; }
  bool out_of_budget() const {
    return mesh_.vertex_count() >= budget_ || turns_ / turns_per_vertex >= budget_;
  }

  std::vector<SphereViolation> violations() const { return flips_.violations(); }
  std::size_t tame() const { return tame_; }
  std::size_t untame() const { return untame_; }

  /// No flip and no tame insertion makes an angle in plan that is below this, or below the bound.
  static constexpr double plan_angle_deg = 15;

 private:
  enum class Kind { plan, space };
  struct Target {
    double badness;
    TriangleId triangle;
    std::array<VertexId, 3> vertices;
    bool operator<(const Target& other) const {
      return badness != other.badness ? badness < other.badness : other.triangle < triangle;
    }
  };
  // An angle in reach, and where it is reached.
  struct Rung {
    explicit Rung(double angle_deg)
        : badness(AngleTest::squared_cos(angle_deg)), place(angle_deg) {}
    double badness;
    FeasiblePlace place;
  };
  using Targets = std::priority_queue<Target>;
  // A place for a vertex, and the worst angle of the star it would get.
  struct Candidate {
    Point place;
    double badness;
  };

  static constexpr std::size_t turns_per_vertex = 100;  // of the budget

  void start(double error);
  bool may_go_on();
  bool take_turn();
  void note_changes();
  void add_targets(TriangleId t);
  void flip_everywhere();
  void flip_planar_back();
  std::optional<TriangleId> next(Targets& targets);
  bool is_improvable(TriangleId t) const;

  // Errors.
  void reduce_error(TriangleId t);
  bool cut_line_at(TriangleId t, Sample s);
  bool insert_in_space(TriangleId t, Point p);
  bool insert_in_plan(TriangleId t, Point p);
  bool grow(TriangleId t, Point p, TerrainMetric metric);
  bool try_in_space(TriangleId t, Point p, std::optional<Candidate>& best);
  bool try_in_plan(TriangleId t, Point p, std::optional<Candidate>& best);
  void fill(TerrainMetric metric);
  bool cut(HalfEdge e, std::optional<Point> at = {});

  // Angles.
  void improve(TriangleId t, Kind kind);
  bool flip_in_plan(TriangleId t);
  bool move_corner(TriangleId t, std::uint32_t corner, Kind kind, Rung& rung);
  void move(VertexId v, Point p);
  double worst_of(const Star& star, const SpacePoint& p, Kind kind) const;
  bool encroaches(const Star& star, Point p) const;
  bool insert_off_centre(TriangleId t, Kind kind);
  bool insert_at_end_of_path(TriangleId t);
  double error_of_star(const Star& star, Point p) const;
  SlopeMap slope_of(const Star& star) const;
  Point snapped(Point p) const;

  const HeightGrid& grid_;
  TerrainMesh& terrain_;
  Mesh& mesh_;
  std::function<bool()> go_on_;
  SurfaceMetric metric_;
  SurfaceFlips flips_;
  SurfaceStar new_star_;
  AngleTest angle_, plan_angle_;
  double bound_, plan_bound_;  // cos^2 of the smallest angles in space and in plan
  OffCentre off_centre_;
  std::deque<Rung> ladder_;
  double clearance_, floor_;
  std::optional<ErrorHeap> heap_;
  Targets thin_, small_;  // below the bound in plan, and in space
  double error_ = 0;
  std::size_t budget_;  // of vertices: every sample, and as many places between them
  std::size_t most_vertices_ = 0, frozen_, tame_ = 0, untame_ = 0, turns_ = 0;
  bool cancelled_ = false, started_ = false;
  std::optional<HalfEdge> barrier_;
  Star star_;
  std::vector<std::uint8_t> moves_;
  std::vector<TriangleId> changed_;
  std::vector<HalfEdge> suspects_;
};

}  // namespace lepp
