#pragma once

#include <Eigen/Core>
#include <span>

#include "linear_system.hpp"

namespace lepp::demo {

/// z is about K^-1 r: symmetric and positive definite on the free vertices, 0 elsewhere.
class Preconditioner {
 public:
  virtual ~Preconditioner() = default;
  virtual void apply(const Eigen::VectorXd& r, Eigen::VectorXd& z) const = 0;
};

struct IterativeSolution {
  Eigen::VectorXd u;
  std::size_t iterations = 0;
  bool converged = false;
};

/// Conjugate gradients with that preconditioner, from `start`, which has the given values already.
/// \param free       one per vertex: 0 where a value is given
/// \param reduction  of the error in the norm of B K, about the energy norm, against that of the
///                   start that is 0 at all free vertices
IterativeSolution solve_iteratively(const LinearSystem& system, std::span<const char> free,
                                    const Preconditioner& preconditioner, Eigen::VectorXd start,
                                    double reduction = 1e-8);

/// The same for those who cannot go on without a solution.
/// \throw InputError if it does not converge
IterativeSolution solve_or_refuse(const LinearSystem& system, std::span<const char> free,
                                  const Preconditioner& preconditioner, Eigen::VectorXd start);

}  // namespace lepp::demo
