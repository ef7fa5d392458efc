#include "deflation.hpp"

#include <utility>

namespace lepp::demo {

Deflation::Deflation(const SparseMatrix& K, std::span<const char> free, SparseMatrix modes)
    : modes_(std::move(modes)) {
  if (is_empty()) return;
  K_modes_ = K * modes_;
  K_modes_.prune([&](Eigen::Index row, Eigen::Index, double) {
    return free[static_cast<std::size_t>(row)] != 0;
  });
  SparseMatrix E = modes_.transpose() * K_modes_;
  // Makes it definite, should functions depend on each other or be 0: whatever stands in place of
  // W^T K W, the preconditioner is symmetric and positive definite.
  const double largest = E.diagonal().maxCoeff();
  for (Eigen::Index i = 0; i < E.cols(); ++i) {
    E.coeffRef(i, i) += 1e-12 * (E.coeff(i, i) + 1e-3 * largest);
  }
  factors_.compute(E);
}

Eigen::VectorXd Deflation::take_out(Eigen::VectorXd& r) const {
  Eigen::VectorXd coefficients = factors_.solve(modes_.transpose() * r);
  r -= K_modes_ * coefficients;
  return coefficients;
}

void Deflation::put_back(const Eigen::VectorXd& coefficients, Eigen::VectorXd& z) const {
  z += modes_ * (coefficients - factors_.solve(K_modes_.transpose() * z));
}

}  // namespace lepp::demo
