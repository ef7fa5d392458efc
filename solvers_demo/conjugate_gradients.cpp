#include "conjugate_gradients.hpp"

#include <utility>

#include "lepp/geometry/error.hpp"

namespace lepp::demo {

IterativeSolution solve_iteratively(const LinearSystem& system, std::span<const char> free,
                                    const Preconditioner& preconditioner, Eigen::VectorXd start,
                                    double reduction) {
  constexpr std::size_t most_iterations = 200;
  const auto on_free = [&](Eigen::VectorXd x) {
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      if (free[static_cast<std::size_t>(k)] == 0) x[k] = 0;
    }
    return x;
  };
  const auto times_K = [&](const Eigen::VectorXd& x) {  // K is symmetric, and rows are faster
    return on_free(system.K.transpose() * x);
  };
  IterativeSolution solution;
  Eigen::VectorXd z;
  Eigen::VectorXd r = on_free(system.b - system.K.transpose() * (start - on_free(start)));
  preconditioner.apply(r, z);
  const double goal = reduction * reduction * r.dot(z);
  r -= times_K(on_free(start));
  solution.u = std::move(start);
  preconditioner.apply(r, z);
  double squared = r.dot(z);
  Eigen::VectorXd p = z;
  while (squared > goal && solution.iterations < most_iterations) {
    const Eigen::VectorXd q = times_K(p);
    const double step = squared / p.dot(q);
    solution.u += step * p;
    r -= step * q;
    preconditioner.apply(r, z);
    const double next = r.dot(z);
    p = z + (next / squared) * p;
    squared = next;
    ++solution.iterations;
  }
  solution.converged = squared <= goal;
  return solution;
}

IterativeSolution solve_or_refuse(const LinearSystem& system, std::span<const char> free,
                                  const Preconditioner& preconditioner, Eigen::VectorXd start) {
  IterativeSolution solution = solve_iteratively(system, free, preconditioner, std::move(start));
  if (solution.converged) return solution;
  throw InputError("the linear system", "is too ill-conditioned for multigrid",
                   "use --solver direct");
}

}  // namespace lepp::demo
