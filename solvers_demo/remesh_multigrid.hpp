#pragma once

#include <Eigen/SparseCholesky>
#include <span>
#include <vector>

#include "conjugate_gradients.hpp"
#include "deflation.hpp"
#include "lepp/triangulation/mesh.hpp"

namespace lepp::demo {

/// The meshes of an adaptive loop that makes each mesh anew, as a hierarchy: not nested, but each
/// can be interpolated on the next one. Keeps those that have at least twice as many vertices as
/// the one kept before, or a triangle at most a quarter as large as its smallest (towards a
/// singular point meshes grow fine with few vertices); of all but the last the interpolation only.
class MeshHistory {
 public:
  /// \param free  one per vertex: 0 where a value is given; the coarse functions are 0 there
  void add(const Mesh& mesh, std::span<const char> free);
  /// Interpolations, the finest first: on `mesh` from the last kept one, on that one from the one
  /// before, and so on. None if there is none.
  std::vector<SparseMatrix> interpolations(const Mesh& mesh, std::span<const char> free) const;

 private:
  SparseMatrix from_last(const Mesh& mesh, std::span<const char> free) const;

  std::vector<SparseMatrix> between_;  // on mesh i + 1 from mesh i, of the kept ones
  bool is_much_finer(const Mesh& mesh) const;

  Mesh last_;
  double last_smallest_ = 0;  // squared longest edge of its smallest triangle
  std::vector<char> last_free_;
};

/// One symmetric V-cycle over such a hierarchy: coarse matrices are P^T A P, one sweep of
/// Gauss-Seidel forwards on the way down and one backwards on the way up, the coarsest level
/// solved.
class RemeshMultigrid : public Preconditioner {
 public:
  /// \param K               symmetric, positive definite on the free vertices
  /// \param free            one per vertex: 0 where a value is given
  /// \param interpolations  the finest first; the rows of the first are the vertices
  /// \param modes           functions that the cycle alone is slow to find: cross_point_modes()
  /// \throw InputError      if the coarsest matrix is not positive definite
  RemeshMultigrid(const SparseMatrix& K, std::span<const char> free,
                  std::vector<SparseMatrix> interpolations, SparseMatrix modes = {});

  /// Not for two threads at once.
  void apply(const Eigen::VectorXd& r, Eigen::VectorXd& z) const override;

  std::size_t levels() const { return levels_.size(); }

 private:
  struct Level {
    SparseMatrix A;  // rows without a diagonal entry are not free
    SparseMatrix P;  // from the next level; empty on the coarsest
  };
  void cycle(std::size_t level, const Eigen::VectorXd& r, Eigen::VectorXd& z) const;

  std::vector<Level> levels_;
  Eigen::SimplicialLDLT<SparseMatrix> coarsest_factors_;
  Deflation deflation_;
};

}  // namespace lepp::demo
