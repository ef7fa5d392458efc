#pragma once

#include "linear_system.hpp"

namespace lepp::demo {

/// Stiffness matrix of piecewise linear finite elements: the sum over triangles T of
/// D |T| grad phi_k . grad phi_l.  Uses gradients only: no angle, no Voronoi box.
/// \param diffusion  D by region
SparseMatrix fe_stiffness(const Mesh& mesh, const std::vector<double>& diffusion);

/// Stiffness, Robin terms and loads, by quadrature points strictly inside triangles and edges.
LinearSystem assemble_fe(const Mesh& mesh, const PoissonProblem& problem);

/// Solves with finite elements (P1, Galerkin).
/// \pre    `mesh` satisfies M1 to M4; the vectors of `problem` are as long as its regions
/// \throw  InputError  if the solution is not unique
/// Source  docs/algorithms/poisson.md
Solution solve_fe(const Mesh& mesh, const PoissonProblem& problem);

}  // namespace lepp::demo
