#include "remesh_multigrid.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "lepp/bisection/transfer_matrix.hpp"
#include "lepp/geometry/error.hpp"

namespace lepp::demo {
namespace {

/// The rows and columns of free vertices.
SparseMatrix on_free(SparseMatrix A, std::span<const char> free) {
  A.prune([&](Eigen::Index k, Eigen::Index l, double) {
    return free[static_cast<std::size_t>(k)] != 0 && free[static_cast<std::size_t>(l)] != 0;
  });
  return A;
}

/// One sweep for A z = r; A is symmetric, so that its columns are its rows. Vertices that are not
/// free, and functions of a coarse mesh that are 0 at all free vertices, have none.
template <bool forwards>
void sweep(const SparseMatrix& A, const Eigen::VectorXd& r, Eigen::VectorXd& z) {
  const Eigen::Index n = A.cols();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index k = forwards ? i : n - 1 - i;
    double diagonal = 0, sum = r[k];
    for (SparseMatrix::InnerIterator entry(A, k); entry; ++entry) {
      if (entry.row() == k) diagonal = entry.value();
      else sum -= entry.value() * z[entry.row()];
    }
    if (diagonal > 0) z[k] = sum / diagonal;
  }
}

/// Of the triangle whose longest edge is the shortest.
double smallest_squared_diameter(const Mesh& mesh) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    smallest = std::min(smallest, std::max({squared_distance(a, b), squared_distance(b, c),
                                            squared_distance(c, a)}));
  }
  return smallest;
}

}  // namespace

SparseMatrix MeshHistory::from_last(const Mesh& mesh, std::span<const char> free) const {
  SparseMatrix P = interpolation(vertex_transfer(last_, mesh));
  P.prune([&](Eigen::Index k, Eigen::Index l, double) {
    return free[static_cast<std::size_t>(k)] != 0 && last_free_[static_cast<std::size_t>(l)] != 0;
  });
  return P;
}

// Gauss-Seidel finds what the coarse mesh lacks where edges are up to a few times shorter.
bool MeshHistory::is_much_finer(const Mesh& mesh) const {
  return mesh.vertex_count() >= 2 * last_.vertex_count() ||
         16 * smallest_squared_diameter(mesh) <= last_smallest_;
}

void MeshHistory::add(const Mesh& mesh, std::span<const char> free) {
  if (!is_much_finer(mesh)) return;
  if (last_.vertex_count() > 0) between_.push_back(from_last(mesh, free));
  last_ = mesh;
  last_smallest_ = smallest_squared_diameter(mesh);
  last_free_.assign(free.begin(), free.end());
}

std::vector<SparseMatrix> MeshHistory::interpolations(const Mesh& mesh,
                                                      std::span<const char> free) const {
  if (last_.vertex_count() == 0) return {};
  std::vector<SparseMatrix> finest_first = {from_last(mesh, free)};
  finest_first.insert(finest_first.end(), between_.rbegin(), between_.rend());
  return finest_first;
}

RemeshMultigrid::RemeshMultigrid(const SparseMatrix& K, std::span<const char> free,
                                 std::vector<SparseMatrix> interpolations, SparseMatrix modes)
    : deflation_(K, free, std::move(modes)) {
  SparseMatrix A = on_free(K, free);
  for (SparseMatrix& P : interpolations) {
    SparseMatrix coarser = P.transpose() * SparseMatrix(A * P);
    levels_.push_back({std::move(A), std::move(P)});
    A = std::move(coarser);
  }
  SparseMatrix coarsest = A;
  for (Eigen::Index k = 0; k < A.cols(); ++k) {
    if (A.coeff(k, k) == 0) coarsest.coeffRef(k, k) = 1;  // its right-hand side is 0
  }
  levels_.push_back({std::move(A), {}});
  coarsest_factors_.compute(coarsest);
  if (coarsest_factors_.info() != Eigen::Success || coarsest_factors_.vectorD().minCoeff() <= 0) {
    throw InputError("the linear system", "is not positive definite",
                     "check the coefficients, and that each part has a Dirichlet or Robin value");
  }
}

void RemeshMultigrid::apply(const Eigen::VectorXd& r, Eigen::VectorXd& z) const {
  if (deflation_.is_empty()) return cycle(0, r, z);
  Eigen::VectorXd rest = r;
  const Eigen::VectorXd found = deflation_.take_out(rest);
  cycle(0, rest, z);
  deflation_.put_back(found, z);
}

void RemeshMultigrid::cycle(std::size_t level, const Eigen::VectorXd& r, Eigen::VectorXd& z) const {
  const auto& [A, P] = levels_[level];
  if (level + 1 == levels_.size()) {
    z = coarsest_factors_.solve(r);
    return;
  }
  z.setZero(r.size());
  sweep<true>(A, r, z);
  Eigen::VectorXd coarse;
  cycle(level + 1, P.transpose() * (r - A * z), coarse);
  z += P * coarse;
  sweep<false>(A, r, z);
}

}  // namespace lepp::demo
