#include "linear_system.hpp"

#include <Eigen/SparseCholesky>
#include <optional>

#include "lepp/geometry/error.hpp"

namespace lepp::demo {
namespace {

using Fixed = std::vector<std::optional<FixedValue>>;

/// For each vertex its row among the free ones.
struct FreeRows {
  std::vector<std::optional<int>> row;
  int count = 0;
};

FreeRows free_rows(const Fixed& fixed) {
  FreeRows free;
  free.row.resize(fixed.size());
  for (std::size_t v = 0; v < fixed.size(); ++v) {
    if (!fixed[v]) free.row[v] = free.count++;
  }
  return free;
}

/// Keeps rows and columns of free vertices; known columns go to the right-hand side.
LinearSystem restricted(const LinearSystem& system, const Fixed& fixed, const FreeRows& free) {
  LinearSystem small{SparseMatrix(free.count, free.count), Eigen::VectorXd(free.count)};
  for (std::size_t v = 0; v < fixed.size(); ++v) {
    if (free.row[v]) small.b[*free.row[v]] = system.b[static_cast<Eigen::Index>(v)];
  }
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(system.K.nonZeros()));
  for (Eigen::Index column = 0; column < system.K.outerSize(); ++column) {
    const auto l = static_cast<std::size_t>(column);
    for (SparseMatrix::InnerIterator entry(system.K, column); entry; ++entry) {
      const auto k = static_cast<std::size_t>(entry.row());
      if (!free.row[k]) continue;
      if (free.row[l]) entries.emplace_back(*free.row[k], *free.row[l], entry.value());
      else small.b[*free.row[k]] -= entry.value() * fixed[l]->value;
    }
  }
  small.K.setFromTriplets(entries.begin(), entries.end());
  return small;
}

std::vector<double> inflow(const LinearSystem& system, const Eigen::VectorXd& u, const Fixed& fixed,
                           std::size_t conditions) {
  std::vector<double> sums(conditions, 0.0);
  const Eigen::VectorXd left = system.K * u - system.b;
  for (std::size_t v = 0; v < fixed.size(); ++v) {
    if (fixed[v]) sums[fixed[v]->condition] += left[static_cast<Eigen::Index>(v)];
  }
  return sums;
}

}  // namespace

Solution solve(const Mesh& mesh, const PoissonProblem& problem, const LinearSystem& system) {
  check_unique(mesh, problem);
  const Fixed fixed = fixed_values(mesh, problem);
  const FreeRows free = free_rows(fixed);
  Solution solution;
  solution.unknowns = static_cast<std::size_t>(free.count);
  Eigen::VectorXd values(free.count);
  if (free.count > 0) {
    const LinearSystem small = restricted(system, fixed, free);
    const Eigen::SimplicialLDLT<SparseMatrix> factors(small.K);
    if (factors.info() != Eigen::Success || factors.vectorD().minCoeff() <= 0) {
      throw InputError("the linear system", "is not positive definite",
                       "check the mesh with `lepp check --admissible` and the coefficients");
    }
    values = factors.solve(small.b);
  }
  solution.u.resize(static_cast<Eigen::Index>(fixed.size()));
  for (std::size_t v = 0; v < fixed.size(); ++v) {
    solution.u[static_cast<Eigen::Index>(v)] = fixed[v] ? fixed[v]->value : values[*free.row[v]];
  }
  solution.inflow = inflow(system, solution.u, fixed, problem.dirichlet.size());
  return solution;
}

}  // namespace lepp::demo
