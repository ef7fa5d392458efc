#pragma once

#include <Eigen/Core>
#include <functional>

#include "problem.hpp"

namespace lepp::demo {

/// A solution known in closed form.
struct ExactSolution {
  Field value;
  std::function<Point(Point)> gradient;  ///< needed for the H1 norm only
};

/// Norms of u_h - u, where u_h is the piecewise linear function with the given vertex values (for
/// finite volumes: the interpolant of the box values). By a seven-point rule, exact for degree 5.
struct ErrorNorms {
  double l2 = 0;  ///< (integral of |u_h - u|^2)^(1/2)
  double h1 = 0;  ///< (integral of |u_h - u|^2 + |grad u_h - grad u|^2)^(1/2)
};
ErrorNorms error_norms(const Mesh& mesh, const Eigen::VectorXd& u, const ExactSolution& exact);

}  // namespace lepp::demo
