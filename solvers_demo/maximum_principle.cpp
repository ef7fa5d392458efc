#include "maximum_principle.hpp"

#include <cmath>
#include <limits>

#include "admissible_mesh.hpp"
#include "drawing.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/quality.hpp"
#include "lepp/voronoi/admissible.hpp"
#include "poisson_fe.hpp"
#include "poisson_fv.hpp"

namespace lepp::demo {
namespace {

constexpr double length = 4, height = 0.1;
constexpr int pieces = 8;  // of each long side

double linear_value(Point p) { return p.x + 2 * p.y; }

Field constant(double value) {
  return [value](Point) { return value; };
}

/// Points along a horizontal line, their distances all `step`.
std::vector<VertexId> row(Drawing& draw, Point first, double step, int count) {
  std::vector<VertexId> points;
  for (int i = 0; i < count; ++i) points.push_back(draw.point({first.x + i * step, first.y}));
  return points;
}

SchemeOutcome outcome(const Mesh& mesh, const Solution& step, const Solution& linear) {
  SchemeOutcome result{step.u, step.u.minCoeff(), step.u.maxCoeff(), 0};
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const double error = linear.u[static_cast<Eigen::Index>(v)] - linear_value(mesh.points()[v]);
    result.linear_error = std::max(result.linear_error, std::abs(error));
  }
  return result;
}

PlateOutcome solve_on(Mesh mesh, const ThinPlate& plate) {
  const VoronoiBoxes boxes = voronoi_boxes(mesh);
  PlateOutcome result;
  result.admissible = certify(mesh, boxes).admissible;
  result.obtuse_constrained = measure(mesh).obtuse_constrained.exact;
  result.fe = outcome(mesh, solve_fe(mesh, plate.step), solve_fe(mesh, plate.linear));
  result.fv_unclipped = outcome(mesh, solve_fv_unclipped(mesh, boxes, plate.step),
                                solve_fv_unclipped(mesh, boxes, plate.linear));
  result.fv = outcome(mesh, solve_fv(mesh, boxes, plate.step), solve_fv(mesh, boxes, plate.linear));
  result.mesh = std::move(mesh);
  return result;
}

}  // namespace

// The points above stand over the middles of the pieces below, so that flat triangles, with angles
// of 136 degrees, face both long sides:
//
//   d---u0----u1----u2--- ... ---c      hot: a d and d to the middle of the upper side
//   | /  \   /  \  /  \         |       cold: from there to c, and c b
//   a-----l1----l2---- ...  ----b       insulated: a b
ThinPlate thin_plate() {
  Drawing draw("the thin plate");
  const double step = length / pieces;
  const auto below = row(draw, {0, 0}, step, pieces + 1);
  auto above = row(draw, {step / 2, height}, step, pieces);
  above.insert(above.begin(), draw.point({0, height}));
  above.push_back(draw.point({length, height}));

  const auto middle = above.begin() + pieces / 2 + 1;  // the first cold point is the next one
  std::vector<VertexId> hot_side(above.begin(), middle);
  std::vector<VertexId> cold_side(middle - 1, above.end());
  hot_side.insert(hot_side.begin(), below.front());
  cold_side.push_back(below.back());
  const CurveId insulated = draw.curve("insulated", below);
  const CurveId hot = draw.curve("hot", hot_side), cold = draw.curve("cold", cold_side);
  draw.surface("plate", {length / 2, height / 2});

  ThinPlate plate;
  plate.pslg = draw.pslg();
  plate.step.diffusion = plate.linear.diffusion = {1};
  plate.step.source = plate.linear.source = {Field{}};
  plate.step.dirichlet = {{{"hot", {hot}, {}}, constant(1)}, {{"cold", {cold}, {}}, constant(0)}};
  plate.linear.dirichlet = {{{"hot and cold", {hot, cold}, {}}, linear_value}};
  plate.linear.neumann = {{{"insulated", {insulated}, {}}, constant(-2)}};
  return plate;
}

PlateOutcome plate_with_obtuse_boundary(const ThinPlate& plate) {
  return solve_on(constrained_delaunay(plate.pslg).mesh, plate);
}

PlateOutcome plate_with_nonobtuse_boundary(const ThinPlate& plate) {
  const double no_limit = std::numeric_limits<double>::infinity();
  return solve_on(admissible_mesh(plate.pslg, no_limit).mesh, plate);
}

}  // namespace lepp::demo
