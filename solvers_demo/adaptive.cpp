#include "adaptive.hpp"

#include <chrono>
#include <cmath>
#include <numeric>

#include "estimator.hpp"
#include "lepp/bisection/transfer.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/triangulation/quality.hpp"
#include "multigrid.hpp"
#include "poisson_fe.hpp"

namespace lepp::demo {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// What is left to find, and a first guess.
struct Start {
  std::vector<char> free;  // by vertex
  Eigen::VectorXd u;       // with the given values
  std::size_t unknowns = 0;
};

Start start_from(const Mesh& mesh, const PoissonProblem& problem, std::vector<double> guess) {
  const auto fixed = fixed_values(mesh, problem);
  Start start;
  start.free.resize(fixed.size(), 0);
  for (std::size_t v = 0; v < fixed.size(); ++v) {
    if (fixed[v]) guess[v] = fixed[v]->value;
    else start.free[v] = 1;
    start.unknowns += fixed[v] ? 0 : 1;
  }
  start.u =
      Eigen::Map<const Eigen::VectorXd>(guess.data(), static_cast<Eigen::Index>(guess.size()));
  return start;
}

Eigen::VectorXd solve_by_multigrid(std::span<const NewVertex> made, const LinearSystem& system,
                                   Start start, std::size_t& iterations) {
  const Multigrid multigrid(system.K, start.free, made);
  IterativeSolution solution = solve_iteratively(system, start.free, multigrid, std::move(start.u));
  if (!solution.converged) {
    throw InputError("the linear system", "is too ill-conditioned for multigrid",
                     "use --solver direct");
  }
  iterations = solution.iterations;
  return std::move(solution.u);
}

Eigen::VectorXd solve_step(const Mesh& mesh, std::span<const NewVertex> made,
                           const PoissonProblem& problem, const AdaptiveOptions& options,
                           const std::vector<double>& guess, AdaptiveStep& step) {
  const LinearSystem system = assemble_fe(mesh, problem);
  Start start = start_from(mesh, problem, guess);
  step.unknowns = start.unknowns;
  const auto begin = std::chrono::steady_clock::now();
  Eigen::VectorXd u = options.solver == LinearSolver::direct
                          ? solve(mesh, problem, system).u
                          : solve_by_multigrid(made, system, std::move(start), step.iterations);
  step.solve_seconds = seconds_since(begin);
  return u;
}

std::vector<double> indicators_of(const Mesh& mesh, const PoissonProblem& problem,
                                  Estimator estimator, const Eigen::VectorXd& u) {
  if (estimator == Estimator::zz) return zz_indicators(mesh, problem, u);
  return residual_indicators(mesh, problem, u);
}

/// The mesh of the loop, what made it, and a guess at its vertices.
struct Refined {
  Forest forest;
  std::vector<NewVertex> made;  // all vertices but those of the start
  std::vector<double> guess;

  explicit Refined(const AdaptiveProblem& problem)
      : forest(problem.start), guess(problem.start.vertex_count(), 0.0) {
    for (std::size_t i = 0; i < problem.first_rounds; ++i) {
      const std::vector<double> alike(forest.mesh().triangle_count(), 0.0);
      bisect(largest_indicators(alike, 1));
    }
  }
  /// False if nothing could be cut.
  bool bisect(const std::vector<TriangleId>& marked) {
    const Refinement refinement = forest.bisect(marked);
    made.insert(made.end(), refinement.vertices.begin(), refinement.vertices.end());
    transfer_vertices(refinement, guess);
    return !refinement.vertices.empty();
  }
};

}  // namespace

std::vector<AdaptiveStep> run_adaptive(const AdaptiveProblem& problem,
                                       const AdaptiveOptions& options,
                                       const AdaptiveStepDone& step_done) {
  Refined refined(problem);
  const Mesh& mesh = refined.forest.mesh();
  std::vector<AdaptiveStep> steps;
  while (true) {  // ends: each step adds vertices
    AdaptiveStep step{mesh.vertex_count(), mesh.triangle_count()};
    const Eigen::VectorXd u =
        solve_step(mesh, refined.made, problem.problem, options, refined.guess, step);
    const std::vector<double> indicators =
        indicators_of(mesh, problem.problem, options.estimator, u);
    step.error = energy_error(mesh, u, problem);
    step.estimate = std::sqrt(std::accumulate(indicators.begin(), indicators.end(), 0.0));
    step.min_angle_deg = measure(mesh).min_angle_deg;
    steps.push_back(step);
    if (step_done) step_done(step, mesh, u, indicators);
    if (step.unknowns >= options.max_unknowns) return steps;
    refined.guess.assign(u.begin(), u.end());
    if (!refined.bisect(largest_indicators(indicators, options.theta))) return steps;
  }
}

double observed_rate(const std::vector<AdaptiveStep>& steps, double AdaptiveStep::*quantity) {
  double n = 0, x_sum = 0, y_sum = 0, xx = 0, xy = 0;
  for (const AdaptiveStep& step : steps) {
    if (10 * step.unknowns < steps.back().unknowns || step.unknowns == 0) continue;
    const double x = std::log(static_cast<double>(step.unknowns)), y = std::log(step.*quantity);
    n += 1;
    x_sum += x;
    y_sum += y;
    xx += x * x;
    xy += x * y;
  }
  return -(n * xy - x_sum * y_sum) / (n * xx - x_sum * x_sum);
}

}  // namespace lepp::demo
