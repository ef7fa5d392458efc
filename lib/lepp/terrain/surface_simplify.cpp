#include "lepp/terrain/surface_simplify.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "lepp/geometry/compensated_sum.hpp"
#include "lepp/terrain/lepp_simplify.hpp"
#include "lepp/terrain/surface_loop.hpp"
#include "lepp/terrain/surface_metric.hpp"
#include "lepp/triangulation/flip.hpp"

namespace lepp {

namespace {

double degrees_of_badness(double squared_cos) {
  return std::acos(std::sqrt(std::min(squared_cos, 1.0))) * 180 / std::numbers::pi;
}

class SurfaceSimplification {
 public:
  SurfaceSimplification(TerrainMesh& terrain, Levels& levels, const SimplifyOptions& options)
      : terrain_(terrain),
        mesh_(terrain.mesh()),
        levels_(levels),
        options_(options),
        loop_(terrain, options.min_angle_deg,
              [this] { return levels_.ask_now_and_then(mesh_.vertex_count()); }) {}

  void run(SimplifyReport& report) {
    double bound = 0;
    for (bool is_coarse = true, is_first = true;; is_first = false) {
      if (is_coarse && !is_first) make_planar();
      if (is_coarse) make_coarse();
      is_coarse = is_coarse && mesh_.vertex_count() >= levels_.vertices();
      bound = levels_.error();
      loop_.run(bound, levels_.vertices());
      const bool has_more = levels_.next(terrain_.tin(), loop_.largest_error(),
                                         small_angles_in_plan(levels_.vertices()));
      if (!has_more) break;
      loop_.freeze();
    }
    report.unfinished = small_angles_in_plan(options_.max_vertices);
    report.surface.violations = loop_.editor().flips().violations();
    report.surface.bound = bound;
    report.surface.plan_angle_deg = SurfaceLoop::plan_angle_deg(options_.min_angle_deg);
    report.surface.tame = loop_.editor().tame();
    report.surface.untame = loop_.editor().untame();
  }

 private:
  // Undoes the flips of a level that ended before the coarse mesh was complete.
  void make_planar() {
    make_delaunay(terrain_.mesh());
    terrain_.rescan_all();
  }

  // The planar simplification: as if any error would do, or to the error of the first level where
  // its clean-up is worth the time.
  void make_coarse() {
    SimplifyOptions coarse = options_;
    if (options_.effort == Effort::fast) {
      coarse.max_error = std::numeric_limits<double>::infinity();
    } else if (!options_.level_errors.empty()) {
      coarse.max_error = options_.level_errors.front();
    }
    coarse.max_vertices = levels_.vertices();
    coarse.progress = [this](std::size_t vertices) { return levels_.ask(vertices); };
    coarse.level_errors = {};
    coarse.level_vertices = {};
    SimplifyReport report;
    Levels levels(terrain_.grid(), coarse, report);
    loop_.take_over(lepp_simplify(terrain_, levels, coarse));
  }

  std::vector<Unfinished> small_angles_in_plan(std::size_t most_vertices) const {
    const bool used_up = loop_.out_of_budget() || mesh_.vertex_count() >= most_vertices;
    return small_angles(mesh_,
                        std::min(SurfaceLoop::largest_plan_angle_deg, options_.min_angle_deg),
                        {loop_.cancelled(), used_up}, loop_.at_kept_border());
  }

  TerrainMesh& terrain_;
  const Mesh& mesh_;
  Levels& levels_;
  const SimplifyOptions& options_;
  SurfaceLoop loop_;
};

}  // namespace

void surface_simplify(TerrainMesh& terrain, Levels& levels, const SimplifyOptions& options,
                      SimplifyReport& report) {
  SurfaceSimplification(terrain, levels, options).run(report);
}

void note_angles(const HeightGrid& grid, const Tin& tin, double min_angle_deg,
                 SurfaceReport& report) {
  const AngleTest angle(min_angle_deg);
  const auto at = [&](VertexId v) {
    const Point p = tin.mesh.point(v);
    return SpacePoint{p.x, p.y, tin.heights[v.index()] / grid.cell_width};
  };
  CompensatedSum sum;
  double worst = 0;
  for (const Triangle& t : tin.mesh.triangles()) {
    const SpacePoint a = at(t.vertices[0]), b = at(t.vertices[1]), c = at(t.vertices[2]);
    const double bad = badness(a, b, c);
    sum.add(degrees_of_badness(bad));
    worst = std::max(worst, bad);
    if (angle.is_below(squared_distance(a, b), squared_distance(b, c), squared_distance(c, a))) {
      ++report.below_bound;
    }
  }
  report.mean_min_angle_deg = sum.value() / static_cast<double>(tin.mesh.triangle_count());
  report.min_angle_deg = degrees_of_badness(worst);
}

}  // namespace lepp
