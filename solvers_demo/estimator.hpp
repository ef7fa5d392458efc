#pragma once

#include <span>
#include <vector>

#include "linear_system.hpp"

namespace lepp::demo {

/// The gradient of the piecewise linear function with these vertex values, by triangle.
std::vector<Point> gradients(const Mesh& mesh, const Eigen::VectorXd& u);

// Both estimators give eta_T^2, one per triangle; their sum estimates the squared energy error
// integral of D |grad u_h - grad u|^2, up to a constant factor.

/// Residual estimator, the weights such that neither the size of a jump in D nor that of D counts
/// [bernardi2000]:
///   eta_T^2 = h_T^2 / D |f|^2_T + sum over edges in the domain of |e| / (2 max D) |[D du/dn]|^2_e,
/// h_T the longest edge, |.| integrals of squares, max D that of the two sides.
/// \pre  Dirichlet values on all of the boundary, and no source on interior curves
std::vector<double> residual_indicators(const Mesh& mesh, const PoissonProblem& problem,
                                        const Eigen::VectorXd& u);

/// Estimator of Zienkiewicz and Zhu [zienkiewicz1987]: eta_T^2 = D |G - grad u_h|^2_T, where G is
/// linear on T and at each corner the mean of the gradients around it in the region of T, weighted
/// by areas. Nothing is averaged across interfaces, where gradients jump. The quotient of estimate
/// and error tends to 1 on meshes that are regular nearly everywhere, as those of bisections.
std::vector<double> zz_indicators(const Mesh& mesh, const PoissonProblem& problem,
                                  const Eigen::VectorXd& u);

/// Marking of Doerfler [doerfler1996]: the fewest triangles such that the sum of eta_T^2 over them
/// is at least theta times the sum over all. (Others write theta^2 for this theta.) With theta = 1
/// all triangles, those without an error too.
/// \pre  0 < theta <= 1
std::vector<TriangleId> largest_indicators(std::span<const double> indicators, double theta);

}  // namespace lepp::demo
