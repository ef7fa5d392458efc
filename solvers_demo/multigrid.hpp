#pragma once

#include <Eigen/SparseCholesky>
#include <cstdint>
#include <span>
#include <vector>

#include "conjugate_gradients.hpp"
#include "deflation.hpp"
#include "lepp/bisection/forest.hpp"
#include "linear_system.hpp"

namespace lepp::demo {

/// One symmetric V-cycle as a preconditioner. A level lacks the vertices of the one before it that
/// have only older ones next to them, as if Forest::coarsen() had been called for all. On each
/// level Gauss-Seidel runs over the vertices that the next level lacks and those that they lie
/// between, forwards on the way down and backwards on the way up; all other values are as smooth as
/// the next level needs them. So one cycle costs as much as there are vertices, on meshes with any
/// grading. Coarse matrices are P^T A P, made row by row as vertices are removed. Source
/// [chen2012]; docs/algorithms/adaptive.md
class Multigrid : public Preconditioner {
 public:
  /// \param K     symmetric, positive definite on the free vertices; its entries are the mesh's
  ///              edges and diagonals, whatever their values
  /// \param free  one per vertex: 0 where a value is given; then also between two such vertices, on
  ///              the edge between them
  /// \param made  all vertices but those of the roots, in the order in which they were made
  /// \param modes functions that the cycle alone is slow to find, if any: cross_point_modes()
  Multigrid(const SparseMatrix& K, std::span<const char> free, std::span<const NewVertex> made,
            SparseMatrix modes = {});

  /// Not for two threads at once.
  void apply(const Eigen::VectorXd& r, Eigen::VectorXd& z) const override;

  std::size_t levels() const { return levels_.size(); }

 private:
  struct Removed {
    std::uint32_t v, a, b;
  };
  struct Entry {
    std::uint32_t column;
    double value;
  };
  // A row that is smoothed; its entries off the diagonal end where those of the next one start.
  struct Row {
    std::uint32_t vertex;
    std::size_t begin;
    double diagonal;
    double right = 0, before = 0;  // of one cycle: right-hand side, and value after the way down
  };
  struct Level {
    std::size_t rows_begin, rows_end;
    std::size_t removed_begin, removed_end;
  };
  class Elimination;

  std::span<const Entry> entries(std::size_t row) const {
    return std::span(entries_).subspan(rows_[row].begin, rows_[row + 1].begin - rows_[row].begin);
  }
  void factorise_coarsest(const Elimination& rest);
  void cycle(Eigen::VectorXd& z) const;
  void go_down(const Level& level) const;
  void go_up(const Level& level, Eigen::VectorXd& z) const;

  std::vector<Level> levels_;
  std::vector<Removed> removed_;
  mutable std::vector<Row> rows_;  // and one that ends the last
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> coarsest_;  // free vertices of the roots
  Eigen::SimplicialLDLT<SparseMatrix> coarsest_factors_;
  Deflation deflation_;
  mutable Eigen::VectorXd residual_;
};

}  // namespace lepp::demo
