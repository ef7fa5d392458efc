#include "maximum_principle.hpp"

#include <doctest/doctest.h>

#include "poisson_fe.hpp"
#include "two_materials.hpp"

using namespace lepp;
using namespace lepp::demo;

TEST_CASE("obtuse angles at the boundary break the maximum principle visibly") {
  const PlateOutcome obtuse = plate_with_obtuse_boundary(thin_plate());
  CHECK(obtuse.obtuse_constrained > 0);
  CHECK_FALSE(obtuse.admissible);
  for (const SchemeOutcome& scheme : {obtuse.fe, obtuse.fv_unclipped}) {
    CHECK(scheme.lowest < -0.05);
    CHECK(scheme.highest > 1.05);
    CHECK(scheme.linear_error < 1e-10);
  }
  // Clipping the boxes keeps the bounds, at the price of a wrong solution.
  CHECK(obtuse.fv.lowest >= -1e-12);
  CHECK(obtuse.fv.highest <= 1 + 1e-12);
  CHECK(obtuse.fv.linear_error > 0.01);
}

TEST_CASE("the maximum principle holds on our mesh, for every scheme") {
  const PlateOutcome nonobtuse = plate_with_nonobtuse_boundary(thin_plate());
  CHECK(nonobtuse.obtuse_constrained == 0);
  CHECK(nonobtuse.admissible);
  for (const SchemeOutcome& scheme : {nonobtuse.fe, nonobtuse.fv_unclipped, nonobtuse.fv}) {
    CHECK(scheme.lowest >= -1e-12);
    CHECK(scheme.highest <= 1 + 1e-12);
    CHECK(scheme.linear_error < 1e-10);
  }
}

TEST_CASE("the stiffness is an M-matrix on an admissible mesh, for every pair of materials") {
  for (const double jump : {1.0, 1e4, 1e-4}) {
    CAPTURE(jump);
    const AdmissibleMesh made = admissible_mesh(test::two_materials_pslg(), 0.1);
    const SparseMatrix K = fe_stiffness(made.mesh, {1, jump});
    double largest_off_diagonal = -1;
    for (Eigen::Index column = 0; column < K.outerSize(); ++column) {
      for (SparseMatrix::InnerIterator entry(K, column); entry; ++entry) {
        if (entry.row() == column) continue;
        largest_off_diagonal = std::max(largest_off_diagonal, entry.value());
      }
    }
    CHECK(largest_off_diagonal <= 1e-12 * std::max(1.0, jump));
  }
}
