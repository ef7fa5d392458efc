#include "lepp/terrain/surface_simplify.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "lepp/geometry/compensated_sum.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/terrain/lepp_loop.hpp"
#include "lepp/terrain/surface_loop.hpp"
#include "lepp/terrain/surface_metric.hpp"

namespace lepp {

namespace {

// The planar simplification of at most so many vertices, as if any error would do.
void make_coarse(const HeightGrid& grid, TerrainMesh& terrain, const SimplifyOptions& options,
                 std::size_t vertices) {
  LeppLoop loop(grid, terrain, options);
  loop.run(std::numeric_limits<double>::infinity(), vertices);
}

std::vector<Unfinished> small_angles_in_plan(const Mesh& mesh, double bound_deg, Reason otherwise) {
  RefineOptions asked;
  asked.min_angle_deg = bound_deg;
  asked.obtuse = ObtuseRule::ignore;
  return judge(mesh, asked, otherwise).unfinished;
}

double degrees_of_badness(double squared_cos) {
  return std::acos(std::sqrt(std::min(squared_cos, 1.0))) * 180 / std::numbers::pi;
}

}  // namespace

void surface_simplify(const HeightGrid& grid, TerrainMesh& terrain, Levels& levels,
                      const SimplifyOptions& options, SimplifyReport& report) {
  const Mesh& mesh = terrain.mesh();
  bool is_coarse = true;
  double bound = 0;
  SurfaceLoop loop(grid, terrain, options.min_angle_deg,
                   [&] { return !options.progress || options.progress(mesh.vertex_count()); });
  do {
    loop.freeze();
    if (is_coarse) make_coarse(grid, terrain, options, levels.vertices());
    is_coarse = is_coarse && mesh.vertex_count() >= levels.vertices();
    bound = levels.error();
    loop.run(bound, levels.vertices());
  } while (!loop.cancelled() && !loop.out_of_budget() &&
           levels.go_on(terrain.tin(), loop.largest_error()));
  const bool used_up = loop.out_of_budget() || mesh.vertex_count() >= options.max_vertices;
  const Reason otherwise = loop.cancelled() || levels.cancelled() ? Reason::cancelled
                           : used_up                              ? Reason::budget
                                                                  : Reason::size_floor;
  report.unfinished = small_angles_in_plan(
      mesh, std::min(SurfaceLoop::largest_plan_angle_deg, options.min_angle_deg), otherwise);
  report.surface.violations = loop.editor().flips().violations();
  report.surface.bound = bound;
  report.surface.plan_angle_deg = SurfaceLoop::plan_angle_deg(options.min_angle_deg);
  report.surface.tame = loop.editor().tame();
  report.surface.untame = loop.editor().untame();
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
