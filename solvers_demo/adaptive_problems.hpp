#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "error_norms.hpp"

namespace lepp::demo {

/// Where a solution behaves like r^exponent, 0 < exponent < 1: quadrature has to know.
struct SingularPoint {
  Point at;
  double exponent = 1;
};

/// A problem with a known solution whose difficulty is local; Dirichlet values all around.
struct AdaptiveProblem {
  std::string name, title;
  Mesh start;
  /// How often all triangles are bisected before the first step, so that it sees the data at all.
  std::size_t first_rounds = 0;
  PoissonProblem problem;
  ExactSolution exact;
  std::optional<SingularPoint> singular = {};
};

/// u = r^(2/3) sin(2 theta / 3) on (-1, 1)^2 without its fourth quadrant, from 8 vertices and 6
/// triangles: the gradient is infinite at the corner that points inwards.
AdaptiveProblem l_shape();

/// u = atan(60 (r - pi/3)), r the distance to (1.25, -0.25), on the unit square: a steep front
/// that crosses it along an arc.
AdaptiveProblem arctan_front();

/// u = r^0.1 mu(theta) on (-1, 1)^2 with D = 161.4476... in the first and third quadrant and 1 in
/// the others: the gradient is nearly as singular as one can be. Source [kellogg1974], the data
/// [morin2000].
AdaptiveProblem kellogg();

/// u = exp(-1000 |x - c|^2), c the middle of the unit square: nearly nothing but a peak.
AdaptiveProblem gaussian_peak();

/// One of the above by its name: l-shape, front, kellogg or peak.
/// \throw InputError  listing the names
AdaptiveProblem adaptive_problem(std::string_view name);
std::vector<std::string> adaptive_problem_names();

/// How the error is integrated.
enum class ErrorQuadrature {
  /// By the rule of error_norms(), and where a triangle touches the singular point by Gauss points
  /// that crowd there as the solution does: the true error.
  graded,
  /// By the centroids of 16 equal parts of each triangle: a part of the error is missed, 1.6 %
  /// where the solution is smooth and more at a singular point. Published figures are of this
  /// kind; docs/algorithms/adaptive.md
  centroids,
};

/// (integral of D |grad u_h - grad u|^2)^(1/2); for D = 1 the H1 seminorm of the error.
double energy_error(const Mesh& mesh, const Eigen::VectorXd& u, const AdaptiveProblem& problem,
                    ErrorQuadrature quadrature = ErrorQuadrature::graded);

}  // namespace lepp::demo
