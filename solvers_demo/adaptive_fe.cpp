#include "adaptive_scheme.hpp"
#include "cross_points.hpp"
#include "estimator.hpp"
#include "first_guess.hpp"
#include "lepp/bisection/transfer.hpp"
#include "multigrid.hpp"
#include "poisson_fe.hpp"
#include "stopwatch.hpp"

namespace lepp::demo {
namespace {

class ElementsByBisection : public AdaptiveScheme {
 public:
  ElementsByBisection(const AdaptiveProblem& problem, LinearSolver solver)
      : problem_(problem.problem),
        solver_(solver),
        forest_(problem.start),
        guess_(problem.start.vertex_count(), 0.0) {
    for (std::size_t i = 0; i < problem.first_rounds; ++i) {
      const std::vector<double> alike(mesh().triangle_count(), 0.0);
      bisect(largest_indicators(alike, 1));
    }
  }

  const Mesh& mesh() const override { return forest_.mesh(); }

  Eigen::VectorXd solve(AdaptiveStep& step) override {
    const LinearSystem system = assemble_fe(mesh(), problem_);
    FirstGuess start = first_guess(mesh(), problem_, guess_);
    step.unknowns = start.unknowns;
    const Stopwatch watch;
    Eigen::VectorXd u = solver_ == LinearSolver::direct
                            ? demo::solve(mesh(), problem_, system).u
                            : by_multigrid(system, std::move(start), step.iterations);
    step.solve_seconds = watch.seconds();
    return u;
  }

  bool refine(std::span<const TriangleId> marked, const Eigen::VectorXd& u) override {
    guess_.assign(u.begin(), u.end());
    return bisect(marked);
  }

 private:
  bool bisect(std::span<const TriangleId> marked) {
    const Refinement refinement = forest_.bisect(marked);
    made_.insert(made_.end(), refinement.vertices.begin(), refinement.vertices.end());
    transfer_vertices(refinement, guess_);
    return !refinement.vertices.empty();
  }

  Eigen::VectorXd by_multigrid(const LinearSystem& system, FirstGuess start,
                               std::size_t& iterations) const {
    const Multigrid multigrid(system.K, start.free, made_,
                              cross_point_modes(mesh(), problem_.diffusion, start.free));
    IterativeSolution solution = solve_or_refuse(system, start.free, multigrid, std::move(start.u));
    iterations = solution.iterations;
    return std::move(solution.u);
  }

  const PoissonProblem& problem_;
  LinearSolver solver_;
  Forest forest_;
  std::vector<NewVertex> made_;  // all vertices but those of the start
  std::vector<double> guess_;
};

}  // namespace

std::unique_ptr<AdaptiveScheme> elements_by_bisection(const AdaptiveProblem& problem,
                                                      LinearSolver solver) {
  return std::make_unique<ElementsByBisection>(problem, solver);
}

}  // namespace lepp::demo
