#include "adaptive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "adaptive_scheme.hpp"
#include "estimator.hpp"
#include "lepp/triangulation/quality.hpp"

namespace lepp::demo {
namespace {

std::unique_ptr<AdaptiveScheme> scheme_for(const AdaptiveProblem& problem,
                                           const AdaptiveOptions& options) {
  if (options.by == RefineBy::delaunay) return boxes_by_delaunay(problem, options.solver);
  return elements_by_bisection(problem, options.solver);
}

std::vector<double> indicators_of(const Mesh& mesh, const PoissonProblem& problem,
                                  Estimator estimator, const Eigen::VectorXd& u) {
  if (estimator == Estimator::zz) return zz_indicators(mesh, problem, u);
  return residual_indicators(mesh, problem, u);
}

}  // namespace

std::vector<AdaptiveStep> run_adaptive(const AdaptiveProblem& problem,
                                       const AdaptiveOptions& options,
                                       const AdaptiveStepDone& step_done) {
  const auto scheme = scheme_for(problem, options);
  const Mesh& mesh = scheme->mesh();
  std::vector<AdaptiveStep> steps;
  while (true) {  // ends: each step adds vertices
    AdaptiveStep step{mesh.vertex_count(), mesh.triangle_count()};
    const Eigen::VectorXd u = scheme->solve(step);
    const std::vector<double> indicators =
        indicators_of(mesh, problem.problem, options.estimator, u);
    step.error = energy_error(mesh, u, problem, options.error_quadrature);
    step.estimate = std::sqrt(std::accumulate(indicators.begin(), indicators.end(), 0.0));
    step.min_angle_deg = measure(mesh).min_angle_deg;
    steps.push_back(step);
    if (step_done) step_done(step, mesh, u, indicators);
    if (step.unknowns >= options.max_unknowns) return steps;
    if (!scheme->refine(largest_indicators(indicators, options.theta), u)) return steps;
  }
}

std::optional<double> observed_rate(const std::vector<AdaptiveStep>& steps,
                                    double AdaptiveStep::*quantity) {
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  double n = 0, x_sum = 0, y_sum = 0, xx = 0, xy = 0;
  for (const AdaptiveStep& step : steps) {
    if (10 * step.unknowns < steps.back().unknowns || step.unknowns == 0) continue;
    const double x = std::log(static_cast<double>(step.unknowns)), y = std::log(step.*quantity);
    fewest = std::min(fewest, step.unknowns);
    n += 1;
    x_sum += x;
    y_sum += y;
    xx += x * x;
    xy += x * y;
  }
  if (n == 0 || fewest >= steps.back().unknowns) return std::nullopt;
  return -(n * xy - x_sum * y_sum) / (n * xx - x_sum * x_sum);
}

}  // namespace lepp::demo
