#pragma once

#include <Eigen/SparseCholesky>
#include <span>

#include "linear_system.hpp"

namespace lepp::demo {

/// Solves exactly for the part of a solution that is in the span of a few functions, around a
/// preconditioner B that is slow to find it. With Q = W (W^T K W)^-1 W^T, W the functions, the
/// three steps take_out(), B and put_back() are Q + (1 - Q K) B (1 - K Q), which is symmetric and
/// positive definite if B is. Source [mandel1993]
class Deflation {
 public:
  Deflation() = default;
  /// \param K      symmetric, positive definite on the free vertices
  /// \param modes  a function in each column, 0 where a value is given; they may depend on each
  ///               other
  Deflation(const SparseMatrix& K, std::span<const char> free, SparseMatrix modes);

  bool is_empty() const { return modes_.cols() == 0; }
  /// r - K Q r, and the coefficients of Q r.
  Eigen::VectorXd take_out(Eigen::VectorXd& r) const;
  /// z - Q K z, and what take_out() has found.
  void put_back(const Eigen::VectorXd& coefficients, Eigen::VectorXd& z) const;

 private:
  SparseMatrix modes_, K_modes_;
  Eigen::SimplicialLDLT<SparseMatrix> factors_;
};

}  // namespace lepp::demo
