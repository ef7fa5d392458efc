#pragma once

#include <deque>
#include <optional>

#include "lepp/refine/feasible_place.hpp"
#include "lepp/refine/off_centre.hpp"
#include "lepp/terrain/free_stars.hpp"
#include "lepp/terrain/small_angles.hpp"
#include "lepp/terrain/surface_editor.hpp"

namespace lepp {

/// Betters triangles with small angles in the surface metric, as refinement does in the plane: by
/// moving a corner if that does it, else by an off-centre. In space both are sought in the plane of
/// the place (SlopeMap), then judged with the heights that the grid has there.
class SurfaceRepair {
 public:
  enum class Kind {
    plan,   ///< the angle in plan is too small
    space,  ///< the angle in space is; no angle in plan may become too small for that
  };

  /// \param plan_angle_deg  what angles in plan are too small
  SurfaceRepair(SurfaceEditor& editor, double min_angle_deg, double plan_angle_deg);

  /// Vertices that exist now stay where they are from now on.
  void freeze() { free_stars_.freeze(); }
  /// No move takes the error of its triangles above this, or above what it was if that is more.
  void set_error(double error) { error_ = error; }

  /// A good place in a star, or in the star that the editor grew last, by the metric of `kind`.
  std::optional<Point> good_place_near(Point p, Kind kind);

  /// Triangles that could not be bettered because of a side that has to stay whole.
  AtKeptBorder& at_kept_border() { return at_kept_border_; }
  const AtKeptBorder& at_kept_border() const { return at_kept_border_; }

  /// One change, or none if nothing helps.
  void improve(TriangleId t, Kind kind);

 private:
  // An angle, and where a star has it.
  struct Rung {
    explicit Rung(double angle_deg)
        : badness(AngleTest::squared_cos(angle_deg)), place(angle_deg) {}
    double badness;
    FeasiblePlace place;
  };

  std::optional<Point> place_in_star(Rung& rung, Point near, Kind kind);
  bool move_corner(TriangleId t, std::uint32_t corner, Kind kind, Rung& rung);
  double badness_of_star(const SpacePoint& p, Kind kind) const;
  bool encroaches(Point p) const;
  bool insert_off_centre_in_space(TriangleId t);
  bool insert_in_plan(TriangleId t);
  bool cut(TriangleId t, HalfEdge e, double least);
  bool insert_or_cut(TriangleId t, Point p, double most, double least);

  SurfaceEditor& editor_;
  TerrainMesh& terrain_;
  const Mesh& mesh_;
  double plan_badness_;  // cos^2 of the angle in plan
  OffCentre off_centre_;
  std::deque<Rung> ladder_;
  double error_ = 0;
  Star star_, spread_;
  FreeStars free_stars_;
  AtKeptBorder at_kept_border_;
};

}  // namespace lepp
