#pragma once

#include "lepp/voronoi/voronoi_boxes.hpp"
#include "linear_system.hpp"

namespace lepp::demo {

/// The two-point-flux matrix from the faces of the clipped Voronoi boxes: the sum over faces of
/// D sigma_kl / h_kl (u_k - u_l), D that of the region the face lies in.
/// Never positive off the diagonal; consistent with the equation only if the mesh is admissible.
/// \param diffusion  D by region
SparseMatrix fv_stiffness(const Mesh& mesh, const VoronoiBoxes& boxes,
                          const std::vector<double>& diffusion);

/// The same from signed edge factors, as a code does that does not clip its boxes to the domain.
/// Equal to fv_stiffness() on an admissible mesh; elsewhere still consistent, but positive off the
/// diagonal where a factor is negative.
SparseMatrix fv_stiffness_from_factors(const Mesh& mesh, const std::vector<EdgeFactor>& factors,
                                       const std::vector<double>& diffusion);

/// Loads of the boxes: f integrated over each box, fluxes over the half edges that bound it.
/// Robin terms are lumped to the vertices, which keeps the maximum principle.
LinearSystem assemble_fv(const Mesh& mesh, const VoronoiBoxes& boxes,
                         const PoissonProblem& problem);

/// Solves with finite volumes on the Voronoi boxes of `mesh`.
/// \pre    `boxes` belongs to `mesh`, which is admissible (certify()) if the answer is to converge
/// \throw  InputError  if the solution is not unique
/// Source  [eymard2000]; docs/algorithms/poisson.md
Solution solve_fv(const Mesh& mesh, const VoronoiBoxes& boxes, const PoissonProblem& problem);

/// solve_fv() with the matrix of fv_stiffness_from_factors().
Solution solve_fv_unclipped(const Mesh& mesh, const VoronoiBoxes& boxes,
                            const PoissonProblem& problem);

}  // namespace lepp::demo
