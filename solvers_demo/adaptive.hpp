#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "adaptive_problems.hpp"
#include "linear_system.hpp"

namespace lepp::demo {

enum class Estimator { residual, zz };
enum class LinearSolver {
  multigrid,  ///< conjugate gradients with multigrid, from the last solution
  direct,     ///< Eigen's sparse LDL^T
};
enum class RefineBy {
  bisect,    ///< LEPP-bisection, and finite elements on its mesh
  delaunay,  ///< LEPP-Delaunay with sizes from the marks, and finite volumes on its Voronoi boxes
};

struct AdaptiveOptions {
  Estimator estimator = Estimator::residual;
  RefineBy by = RefineBy::bisect;
  LinearSolver solver = LinearSolver::multigrid;
  double theta = 0.5;  ///< of largest_indicators(); 1 refines everywhere
  ErrorQuadrature error_quadrature = ErrorQuadrature::graded;
  std::size_t max_unknowns = 20000;  ///< the first mesh with as many is the last one
};

/// One turn of the loop.
struct AdaptiveStep {
  std::size_t vertices = 0, triangles = 0;
  std::size_t unknowns = 0;  ///< vertices without a Dirichlet value
  double error = 0;          ///< energy_error()
  double estimate = 0;       ///< square root of the sum of the indicators
  double min_angle_deg = 0;
  std::size_t iterations = 0;  ///< of multigrid
  double solve_seconds = 0;    ///< from the assembled system to the solution, set-up included
};

/// Hears about each step; the mesh and the values are those of the step.
using AdaptiveStepDone =
    std::function<void(const AdaptiveStep& step, const Mesh& mesh, const Eigen::VectorXd& u,
                       const std::vector<double>& indicators)>;

/// Solve, estimate, mark, refine, and again. Each solution starts from the last one, transferred;
/// by LEPP-Delaunay each mesh is certified to be admissible before it is used.
/// \throw InputError  if a system is not positive definite, or a mesh not admissible
std::vector<AdaptiveStep> run_adaptive(const AdaptiveProblem& problem,
                                       const AdaptiveOptions& options = {},
                                       const AdaptiveStepDone& step_done = {});

/// The exponent r of error ~ unknowns^-r: least squares over the steps with at least a tenth of the
/// last one's unknowns, in logarithms. Nothing if these steps have only one number of unknowns.
std::optional<double> observed_rate(const std::vector<AdaptiveStep>& steps,
                                    double AdaptiveStep::*quantity);

}  // namespace lepp::demo
