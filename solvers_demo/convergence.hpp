#pragma once

#include <functional>
#include <vector>

#include "admissible_mesh.hpp"
#include "error_norms.hpp"
#include "linear_system.hpp"

namespace lepp::demo {

/// A problem with a known solution on a domain we draw.
struct SolvedProblem {
  Pslg pslg;
  PoissonProblem problem;
  ExactSolution exact;
};

/// A rectangle of two materials, D = 1 and D = 5, that an oblique interface divides, with a
/// hexagonal hole in the first. Dirichlet values left, above and around the hole, a flux below, an
/// exchange on the right: SmoothAcrossInterface (manufactured.hpp) solves it.
SolvedProblem two_materials_with_hole();

struct ConvergenceLevel {
  double h = 0;                            ///< the longest edge asked for
  std::size_t unknowns = 0;                ///< free ones
  double fe_l2 = 0, fe_h1 = 0, fv_l2 = 0;  ///< error norms, error_norms.hpp
  double fe_seconds = 0, fv_seconds = 0;   ///< assembly and solution
};

/// Exponents p of error ~ (unknowns^-1/2)^p.
struct ConvergenceOrders {
  double fe_l2 = 0, fe_h1 = 0, fv_l2 = 0;
};

struct Convergence {
  std::vector<ConvergenceLevel> levels;
  ConvergenceOrders orders;
};

struct ConvergenceOptions {
  double coarsest = 0.2;   ///< h of the first level, halved from level to level
  std::size_t levels = 6;  ///< >= 3
};

/// Hears about each level when it is done.
using LevelDone = std::function<void(const ConvergenceLevel& level, const AdmissibleMesh& mesh,
                                     const Solution& fe, const Solution& fv)>;

/// Solves on a sequence of meshes, each a fresh run of the whole pipeline, by both methods.
Convergence run_convergence(const SolvedProblem& solved, const ConvergenceOptions& options = {},
                            const LevelDone& level_done = {});

/// Least-squares slope of log(error) over log(unknowns^-1/2), over the last three levels.
/// \pre as many errors as unknowns, at least three, all > 0
double observed_order(const std::vector<std::size_t>& unknowns, const std::vector<double>& errors);

}  // namespace lepp::demo
