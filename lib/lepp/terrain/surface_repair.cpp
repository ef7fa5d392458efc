#include "lepp/terrain/surface_repair.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "lepp/terrain/terrain_errors.hpp"
#include "lepp/triangulation/encroached.hpp"
#include "lepp/triangulation/lepp.hpp"

namespace lepp {

namespace {

// The parts of the bound that moves try to reach, one after the other.
constexpr double rungs[] = {1, 0.75, 0.55};

// Nearer to samples, as a part of a cell, a vertex would leave no room for them.
constexpr double clear = 1.0 / 64;

double shortest_in_plan(const Mesh& mesh, TriangleId t) {
  const auto [a, b, c] = mesh.corners(t);
  return std::sqrt(
      std::min({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)}));
}

}  // namespace

SurfaceRepair::SurfaceRepair(SurfaceEditor& editor, double min_angle_deg, double plan_angle_deg)
    : editor_(editor),
      terrain_(editor.terrain()),
      mesh_(editor.mesh()),
      plan_badness_(AngleTest::squared_cos(plan_angle_deg)),
      off_centre_(min_angle_deg),
      free_stars_(mesh_) {
  for (const double part : rungs) ladder_.emplace_back(part * min_angle_deg);
}

void SurfaceRepair::improve(TriangleId t, Kind kind) {
  if (kind == Kind::plan && editor_.flip_in_plan(t)) return;
  for (Rung& rung : ladder_) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (move_corner(t, i, kind, rung)) return;
    }
  }
  if (kind == Kind::plan) insert_in_plan(t);
  else insert_off_centre_in_space(t);
}

// ---- moving --------------------------------------------------------------------------------

// To a place where all angles of the star reach the rung, and the smallest is larger than it was.
bool SurfaceRepair::move_corner(TriangleId t, std::uint32_t corner, Kind kind, Rung& rung) {
  if (!free_stars_.find(t, corner, star_)) return false;
  const VertexId v = mesh_.vertex(t, corner);
  const auto place = place_in_star(rung, mesh_.point(v), kind);
  if (!place) return false;
  const double before = badness_of_star(editor_.metric().at(v), kind);
  const double most_error = std::max(error_, largest_error(terrain_, star_));
  for (const Point p : {terrain_.snapped(*place), terrain_.clear_of_samples(*place, clear)}) {
    if (!sees_link(star_, p) || encroaches(p)) continue;
    const double after = badness_of_star(editor_.metric().at(p), kind);
    if (after > rung.badness || after >= before) continue;
    if (error_of_star(terrain_, star_, p) > most_error) continue;
    editor_.move(v, star_, p);
    free_stars_.note_move(v);
    return true;
  }
  return false;
}

std::optional<Point> SurfaceRepair::place_in_star(Rung& rung, Point near, Kind kind) {
  if (kind == Kind::plan) return rung.place.find(star_, near);
  std::vector<SpacePoint> chain;
  for (const auto& side : star_.link) chain.push_back(editor_.metric().at(mesh_.origin(side.edge)));
  const SlopeMap slope(chain);
  spread_ = star_;
  for (auto& side : spread_.link) side.from = slope.to_plane(side.from);
  const auto place = rung.place.find(spread_, slope.to_plane(near));
  if (!place) return std::nullopt;
  return slope.to_plan(*place);
}

std::optional<Point> SurfaceRepair::good_place_near(Point p, Kind kind) {
  editor_.star().copy_to(star_);
  return place_in_star(ladder_.front(), p, kind);
}

// cos^2 of the smallest angle with the center at p; above 1 if one in plan is too small.
double SurfaceRepair::badness_of_star(const SpacePoint& p, Kind kind) const {
  double worst = 0;
  for (const auto& side : star_.link) {
    const SpacePoint a = editor_.metric().at(mesh_.origin(side.edge)),
                     b = editor_.metric().at(mesh_.destination(side.edge));
    const double in_plan = AngleTest::badness(p.plan(), a.plan(), b.plan());
    if (in_plan > plan_badness_) worst = std::max(worst, 1 + in_plan);
    worst = std::max(worst, kind == Kind::plan ? in_plan : badness(p, a, b));
  }
  return worst;
}

bool SurfaceRepair::encroaches(Point p) const {
  return std::ranges::any_of(star_.link, [&](const Star::LinkEdge& side) {
    return side.constrained && would_encroach(mesh_, side.edge, p);
  });
}

// ---- inserting -----------------------------------------------------------------------------

// Only where the star is tame and its smallest angle larger than that of `t`.
bool SurfaceRepair::insert_off_centre_in_space(TriangleId t) {
  const SlopeMap slope(editor_.metric().corners(t));
  const auto [a, b, c] = mesh_.corners(t);
  const Point p =
      slope.to_plan(off_centre_(slope.to_plane(a), slope.to_plane(b), slope.to_plane(c)));
  const double before = editor_.metric().badness(t);
  for (const Point q : {terrain_.snapped(p), terrain_.clear_of_samples(p, clear)}) {
    if (!editor_.grow(t, q, TerrainMetric::surface)) continue;
    const SurfaceStar& star = editor_.star();
    if (star.encroached() || star.clearance() < editor_.clearance()) continue;
    if (star.badness_in_space() >= before) continue;
    if (!star.is_tame() || star.badness_in_plan() > plan_badness_) continue;
    editor_.fill(TerrainMetric::surface);
    return true;
  }
  return false;
}

// An off-centre, or the end of the LEPP, in plan, if possible where the star is better. Where
// vertices are nearer than a cell already, edges get no shorter than they are. What cannot be
// bettered so is refined without a limit, where all around is Delaunay: then that ends as well.
bool SurfaceRepair::insert_in_plan(TriangleId t) {
  const double least = std::min(editor_.clearance(), shortest_in_plan(mesh_, t));
  const auto [a, b, c] = mesh_.corners(t);
  const double before = AngleTest::badness(a, b, c), anything = 2;
  const Point off_centre = off_centre_(a, b, c);
  const HalfEdge terminal = terminal_edge(mesh_, t);
  const Point middle =
      midpoint(mesh_.point(mesh_.origin(terminal)), mesh_.point(mesh_.destination(terminal)));
  for (const double most : {before, anything}) {
    for (const Point p : {off_centre, middle}) {
      for (const Point q : {terrain_.snapped(p), terrain_.clear_of_samples(p, clear)}) {
        if (insert_or_cut(t, q, most, least)) return true;
      }
    }
  }
  if (mesh_.is_constrained(terminal) && cut(t, terminal, least)) return true;
  if (editor_.lay_flat_around(t)) return true;
  return insert_or_cut(t, off_centre, anything, editor_.floor());
}

bool SurfaceRepair::cut(TriangleId t, HalfEdge e, double least) {
  if (!terrain_.may_cut_with_fan(e)) at_kept_border_.add(mesh_, t);
  return editor_.cut(e, least);
}

// A constrained edge in the way, or encroached, is cut instead.
bool SurfaceRepair::insert_or_cut(TriangleId t, Point p, double most, double least) {
  const bool grown = editor_.grow(t, p, TerrainMetric::planar);
  if (!grown && editor_.barrier()) return cut(t, *editor_.barrier(), least);
  if (!grown) return false;
  const SurfaceStar& star = editor_.star();
  if (const auto e = star.encroached()) return cut(t, *e, least);
  if (star.clearance() < least || star.badness_in_plan() >= most) return false;
  editor_.fill(TerrainMetric::planar);
  return true;
}

}  // namespace lepp
