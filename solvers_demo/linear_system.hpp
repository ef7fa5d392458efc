#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "problem.hpp"

namespace lepp::demo {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// K u = b over all vertices, before any Dirichlet value is put in. Row v is the balance of the
/// hat function, or of the box, of vertex v.
struct LinearSystem {
  SparseMatrix K;
  Eigen::VectorXd b;
};

/// What a solver hands back.
struct Solution {
  Eigen::VectorXd u;         ///< by vertex
  std::size_t unknowns = 0;  ///< free ones: vertices without a Dirichlet value
  /// What flows into the domain at each Dirichlet condition, in the order of the problem: the
  /// balance K u - b that is left at its vertices.
  std::vector<double> inflow;
};

/// Puts the Dirichlet values of `problem` into its assembled system, and solves for the rest by a
/// sparse LDL^T factorisation.
/// \throw InputError  if the solution is not unique, or K is not positive definite
Solution solve(const Mesh& mesh, const PoissonProblem& problem, const LinearSystem& system);

}  // namespace lepp::demo
