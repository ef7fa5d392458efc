#include "convergence.hpp"

#include <chrono>
#include <cmath>

#include "drawing.hpp"
#include "manufactured.hpp"
#include "poisson_fe.hpp"
#include "poisson_fv.hpp"

namespace lepp::demo {
namespace {

/// A regular hexagon, turned so that no side is parallel to an axis.
std::vector<VertexId> hexagon(Drawing& drawing, Point center, double radius) {
  std::vector<VertexId> corners;
  for (int i = 0; i < 6; ++i) {
    const double angle = 0.2 + i * std::numbers::pi / 3;
    corners.push_back(drawing.point(center + radius * Point{std::cos(angle), std::sin(angle)}));
  }
  corners.push_back(corners.front());
  return corners;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

ConvergenceOrders orders_of(const std::vector<ConvergenceLevel>& levels) {
  std::vector<std::size_t> unknowns;
  std::vector<double> fe_l2, fe_h1, fv_l2;
  for (const ConvergenceLevel& level : levels) {
    unknowns.push_back(level.unknowns);
    fe_l2.push_back(level.fe_l2);
    fe_h1.push_back(level.fe_h1);
    fv_l2.push_back(level.fv_l2);
  }
  return {observed_order(unknowns, fe_l2), observed_order(unknowns, fe_h1),
          observed_order(unknowns, fv_l2)};
}

}  // namespace

//        d ------- h ---- c      a (0, 0)    e (0.9, 0)   b (2, 0)
//        |  <hole> /      |      d (0, 1)    h (1.3, 1)   c (2, 1)
//        a ------ e ----- b
SolvedProblem two_materials_with_hole() {
  Drawing draw("the rectangle with a hole and an interface");
  const VertexId a = draw.point({0, 0}), b = draw.point({2, 0}), c = draw.point({2, 1}),
                 d = draw.point({0, 1}), e = draw.point({0.9, 0}), h = draw.point({1.3, 1});
  const CurveId below = draw.curve("below", {a, e, b});
  const CurveId right = draw.curve("right", {b, c});
  const CurveId above = draw.curve("above", {c, h, d});
  const CurveId left = draw.curve("left", {d, a});
  draw.curve("interface", {e, h});
  const CurveId hole = draw.curve("hole", hexagon(draw, {0.5, 0.5}, 0.22));
  draw.hole({0.5, 0.5});
  draw.surface("behind", {0.05, 0.05});
  draw.surface("front", {1.95, 0.5});

  const double across = std::hypot(1, 0.4);
  const SmoothAcrossInterface u{{{0.9, 0}, {1 / across, -0.4 / across}, {1, 5}}};
  const double alpha = 3;
  PoissonProblem problem;
  problem.diffusion.assign(u.materials.diffusion.begin(), u.materials.diffusion.end());
  problem.source.assign(2, [u](Point p) { return u.source(p); });
  problem.dirichlet = {{{"outside", {left, above, hole}, {}}, u.exact().value}};
  problem.neumann = {{{"below", {below}, {}}, [u](Point p) { return u.flux(p, {0, -1}); }}};
  problem.robin = {{{"right", {right}, {}}, alpha, [u, alpha](Point p) {
                      return u.value(p) + u.flux(p, {1, 0}) / alpha;
                    }}};
  return {draw.pslg(), problem, u.exact()};
}

Convergence run_convergence(const SolvedProblem& solved, const ConvergenceOptions& options,
                            const LevelDone& level_done) {
  Convergence convergence;
  double h = options.coarsest;
  for (std::size_t i = 0; i < options.levels; ++i, h /= 2) {
    const AdmissibleMesh made = admissible_mesh(solved.pslg, h);
    const auto start = std::chrono::steady_clock::now();
    const Solution fe = solve_fe(made.mesh, solved.problem);
    const double fe_seconds = seconds_since(start);
    const auto middle = std::chrono::steady_clock::now();
    const Solution fv = solve_fv(made.mesh, made.boxes, solved.problem);
    const double fv_seconds = seconds_since(middle);
    const ErrorNorms fe_error = error_norms(made.mesh, fe.u, solved.exact);
    const ErrorNorms fv_error = error_norms(made.mesh, fv.u, solved.exact);
    convergence.levels.push_back(
        {h, fe.unknowns, fe_error.l2, fe_error.h1, fv_error.l2, fe_seconds, fv_seconds});
    if (level_done) level_done(convergence.levels.back(), made, fe, fv);
  }
  convergence.orders = orders_of(convergence.levels);
  return convergence;
}

double observed_order(const std::vector<std::size_t>& unknowns, const std::vector<double>& errors) {
  constexpr std::size_t last = 3;
  double x_mean = 0, y_mean = 0;
  const auto x = [&](std::size_t i) { return -0.5 * std::log(static_cast<double>(unknowns[i])); };
  const auto y = [&](std::size_t i) { return std::log(errors[i]); };
  for (std::size_t i = errors.size() - last; i < errors.size(); ++i) {
    x_mean += x(i) / last;
    y_mean += y(i) / last;
  }
  double xy = 0, xx = 0;
  for (std::size_t i = errors.size() - last; i < errors.size(); ++i) {
    xy += (x(i) - x_mean) * (y(i) - y_mean);
    xx += (x(i) - x_mean) * (x(i) - x_mean);
  }
  return xy / xx;
}

}  // namespace lepp::demo
