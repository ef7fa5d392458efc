#pragma once

// The one header of bisection that needs Eigen; no other includes it, and nothing is left to link.

#include <Eigen/SparseCore>
#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "lepp/bisection/forest.hpp"
#include "lepp/bisection/remesh_transfer.hpp"
#include "lepp/geometry/error.hpp"

namespace lepp {

// The maps of transfer.hpp and remesh_transfer.hpp as sparse matrices. Rows: vertices or triangles
// of the new mesh, or after the call that returned the log; columns: of the old one, or before.
// Each costs O(rows + columns); transfer.hpp only the change. Such matrices have numbers of 32
// bits: \throw RefusedError above 2^31 - 1 rows, columns or entries

/// P1 through bisect(): of a linear function on each old triangle, the values at all new vertices.
/// Rows of old vertices are those of the identity; each row sums to 1.
/// \param vertices_before  how many there were before the call
Eigen::SparseMatrix<double> prolongation(const Refinement& refinement, std::size_t vertices_before);

/// Its transpose, for loads and residuals: rows before the call, columns after it.
Eigen::SparseMatrix<double> restriction(const Refinement& refinement, std::size_t vertices_before);

/// P0 through bisect(): one 1 in each row.
Eigen::SparseMatrix<double> triangle_prolongation(const Refinement& refinement,
                                                  std::size_t triangles_before);

/// P1 through coarsen(): one 1 in each row, none in the columns of removed vertices.
Eigen::SparseMatrix<double> injection(const Coarsening& coarsening, std::size_t vertices_before);

/// P0 through coarsen(): means weighted by areas, one entry in each column; each row sums to 1.
/// \param areas  one per triangle before the call, all > 0
Eigen::SparseMatrix<double> triangle_averaging(const Coarsening& coarsening,
                                               std::span<const double> areas);

/// P1 to another mesh: at most three entries in each row, which sums to 1.
Eigen::SparseMatrix<double> interpolation(const VertexTransfer& transfer);

/// P0 to another mesh: a row for each new triangle; the areas of the new triangles times this are
/// the areas of the old ones, where integrals are kept.
Eigen::SparseMatrix<double> triangle_projection(const TriangleTransfer& transfer);

// ---- how ---------------------------------------------------------------------------------------

namespace transfer_detail {

inline void check_count(std::size_t count) {
  if (count <= static_cast<std::size_t>(std::numeric_limits<int>::max())) return;
  throw RefusedError("a transfer matrix", "has more than 2^31 - 1 rows, columns or entries",
                     "transfer values without a matrix (transfer.hpp, remesh_transfer.hpp)");
}

struct Entry {
  int column;
  double value;
};
using Row = std::vector<Entry>;  // columns ascending

/// Half the sum of two rows.
inline Row mean(const Row& a, const Row& b) {
  Row sum;
  sum.reserve(a.size() + b.size());
  auto i = a.begin(), j = b.begin();
  while (i != a.end() || j != b.end()) {
    if (j == b.end() || (i != a.end() && i->column < j->column)) {
      sum.push_back({i->column, 0.5 * i->value});
      ++i;
    } else if (i == a.end() || j->column < i->column) {
      sum.push_back({j->column, 0.5 * j->value});
      ++j;
    } else {
      sum.push_back({i->column, 0.5 * (i->value + j->value)});
      ++i;
      ++j;
    }
  }
  return sum;
}

/// A 1 in each row, where `column` says.
inline Eigen::SparseMatrix<double> selection(std::span<const std::uint32_t> column,
                                             std::size_t columns) {
  check_count(std::max(column.size(), columns));
  std::vector<Eigen::Triplet<double>> ones;
  ones.reserve(column.size());
  for (std::size_t row = 0; row < column.size(); ++row) {
    ones.emplace_back(static_cast<int>(row), static_cast<int>(column[row]), 1.0);
  }
  Eigen::SparseMatrix<double> matrix(static_cast<Eigen::Index>(column.size()),
                                     static_cast<Eigen::Index>(columns));
  matrix.setFromTriplets(ones.begin(), ones.end());
  return matrix;
}

inline std::vector<std::uint32_t> counted_up_to(std::size_t n) {
  std::vector<std::uint32_t> numbers(n);
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

}  // namespace transfer_detail

inline Eigen::SparseMatrix<double> prolongation(const Refinement& refinement,
                                                std::size_t vertices_before) {
  using namespace transfer_detail;
  check_count(vertices_before + refinement.vertices.size());
  std::vector<Row> rows;  // of the new vertices
  rows.reserve(refinement.vertices.size());
  const auto row_of = [&](VertexId v) {
    if (v.index() < vertices_before) return Row{{static_cast<int>(v.value), 1.0}};
    return rows[v.index() - vertices_before];
  };
  for (const auto& [v, a, b] : refinement.vertices) rows.push_back(mean(row_of(a), row_of(b)));

  Eigen::SparseMatrix<double, Eigen::RowMajor> P(
      static_cast<Eigen::Index>(vertices_before + rows.size()),
      static_cast<Eigen::Index>(vertices_before));
  const std::size_t entries =
      std::accumulate(rows.begin(), rows.end(), vertices_before,
                      [](std::size_t sum, const Row& row) { return sum + row.size(); });
  check_count(entries);
  P.reserve(static_cast<Eigen::Index>(entries));
  for (Eigen::Index i = 0; i < P.rows(); ++i) {
    P.startVec(i);
    for (const Entry& entry : row_of(VertexId(static_cast<std::size_t>(i)))) {
      P.insertBack(i, entry.column) = entry.value;
    }
  }
  P.finalize();
  return P;
}

inline Eigen::SparseMatrix<double> restriction(const Refinement& refinement,
                                               std::size_t vertices_before) {
  return prolongation(refinement, vertices_before).transpose();
}

inline Eigen::SparseMatrix<double> triangle_prolongation(const Refinement& refinement,
                                                         std::size_t triangles_before) {
  auto parent = transfer_detail::counted_up_to(triangles_before);
  for (const auto& [whole, other] : refinement.triangles) {
    parent.push_back(std::uint32_t{parent[whole.index()]});
  }
  return transfer_detail::selection(parent, triangles_before);
}

inline Eigen::SparseMatrix<double> injection(const Coarsening& coarsening,
                                             std::size_t vertices_before) {
  auto old = transfer_detail::counted_up_to(vertices_before);
  for (const NewVertex& removed : coarsening.vertices) {
    old[removed.vertex.index()] = old.back();
    old.pop_back();
  }
  return transfer_detail::selection(old, vertices_before);
}

inline Eigen::SparseMatrix<double> triangle_averaging(const Coarsening& coarsening,
                                                      std::span<const double> areas) {
  transfer_detail::check_count(areas.size());
  auto now = transfer_detail::counted_up_to(areas.size());  // the old triangle an id stands for
  auto part_of = now;                                       // itself, or one it was joined to
  std::vector<double> sum(areas.begin(), areas.end());
  for (const auto& [whole, other] : coarsening.triangles) {
    const std::uint32_t t = now[whole.index()], u = now[other.index()];
    part_of[u] = t;
    sum[t] += sum[u];
    now[other.index()] = now.back();
    now.pop_back();
  }
  std::vector<int> row_of(areas.size());
  for (std::size_t i = 0; i < now.size(); ++i) row_of[now[i]] = static_cast<int>(i);
  Eigen::SparseMatrix<double> A(static_cast<Eigen::Index>(now.size()),
                                static_cast<Eigen::Index>(areas.size()));
  A.reserve(static_cast<Eigen::Index>(areas.size()));
  for (std::size_t column = 0; column < areas.size(); ++column) {
    auto t = static_cast<std::uint32_t>(column);
    while (part_of[t] != t) t = part_of[t];  // as often as it was joined in this call
    A.startVec(static_cast<Eigen::Index>(column));
    A.insertBack(row_of[t], static_cast<Eigen::Index>(column)) = areas[column] / sum[t];
  }
  A.finalize();
  return A;
}

inline Eigen::SparseMatrix<double> interpolation(const VertexTransfer& transfer) {
  transfer_detail::check_count(std::max(3 * transfer.sources.size(), transfer.vertices_before));
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(3 * transfer.sources.size());
  for (std::size_t row = 0; row < transfer.sources.size(); ++row) {
    const auto& [corners, weights] = transfer.sources[row];
    for (std::size_t i = 0; i < 3; ++i) {
      if (weights[i] == 0) continue;
      entries.emplace_back(static_cast<int>(row), static_cast<int>(corners[i].value), weights[i]);
    }
  }
  Eigen::SparseMatrix<double> P(static_cast<Eigen::Index>(transfer.sources.size()),
                                static_cast<Eigen::Index>(transfer.vertices_before));
  P.setFromTriplets(entries.begin(), entries.end());
  return P;
}

inline Eigen::SparseMatrix<double> triangle_projection(const TriangleTransfer& transfer) {
  transfer_detail::check_count(
      std::max({transfer.shares.size(), transfer.begins.size(), transfer.triangles_before}));
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(transfer.shares.size());
  for (std::size_t row = 0; row + 1 < transfer.begins.size(); ++row) {
    for (const auto& [from, weight] : transfer.of(TriangleId(row))) {
      entries.emplace_back(static_cast<int>(row), static_cast<int>(from.value), weight);
    }
  }
  Eigen::SparseMatrix<double> P(static_cast<Eigen::Index>(transfer.begins.size()) - 1,
                                static_cast<Eigen::Index>(transfer.triangles_before));
  P.setFromTriplets(entries.begin(), entries.end());
  return P;
}

}  // namespace lepp
