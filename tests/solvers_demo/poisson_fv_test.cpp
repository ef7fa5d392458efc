#include "poisson_fv.hpp"

#include <doctest/doctest.h>

#include "../support/hand_made.hpp"
#include "poisson_fe.hpp"
#include "two_materials.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

double relative_difference(const demo::SparseMatrix& A, const demo::SparseMatrix& B) {
  return demo::SparseMatrix(A - B).norm() / A.norm();
}

}  // namespace

TEST_CASE("finite elements and finite volumes give the same matrix on an admissible mesh") {
  for (const double jump : {1.0, 1e4, 1e-4}) {
    for (const double h : {1.0, 0.3, 0.05}) {
      CAPTURE(jump);
      CAPTURE(h);
      const demo::AdmissibleMesh made = demo::admissible_mesh(two_materials_pslg(), h);
      const std::vector<double> D{1, jump};
      const demo::SparseMatrix fe = demo::fe_stiffness(made.mesh, D);
      CHECK(relative_difference(fe, demo::fv_stiffness(made.mesh, made.boxes, D)) < 1e-12);
      const auto factors = edge_factors(made.mesh);
      CHECK(relative_difference(fe, demo::fv_stiffness_from_factors(made.mesh, factors, D)) <
            1e-12);
    }
  }
}

TEST_CASE("with an obtuse angle at the boundary the clipped boxes give another matrix") {
  const Mesh cap = from_triangles({{0, 0}, {4, 0}, {2, 0.2}}, {{0, 1, 2}});
  CHECK(relative_difference(demo::fe_stiffness(cap, {1}),
                            demo::fv_stiffness(cap, voronoi_boxes(cap), {1})) > 0.1);
}

TEST_CASE("finite volumes reproduce a piecewise linear solution over a jump of 1e4") {
  for (const double jump : {1.0, 1e4, 1e-4}) {
    CAPTURE(jump);
    const demo::AdmissibleMesh made = demo::admissible_mesh(two_materials_pslg(), 0.2);
    const demo::PoissonProblem problem = linear_problem(jump);
    const demo::Field exact = linear_solution(jump).exact().value;
    CHECK(relative_error(made.mesh, demo::solve_fv(made.mesh, made.boxes, problem).u, exact) <
          1e-9);
    CHECK(relative_error(made.mesh, demo::solve_fv_unclipped(made.mesh, made.boxes, problem).u,
                         exact) < 1e-9);
  }
}

TEST_CASE("the load of finite volumes is the integral of the source, whatever the mesh") {
  const Mesh mesh = grid({.columns = 6, .rows = 4, .jitter = 0.15, .regions = 2});
  demo::PoissonProblem problem;
  problem.diffusion = {1, 1};
  problem.source = {demo::Field{}, [](Point p) { return p.x * p.y; }};
  const demo::LinearSystem system = demo::assemble_fv(mesh, voronoi_boxes(mesh), problem);
  // x from 3 to 6, y from 0 to 4: 13.5 * 8
  CHECK(system.b.sum() == doctest::Approx(108).epsilon(1e-12));
  const demo::LinearSystem fe = demo::assemble_fe(mesh, problem);
  CHECK(fe.b.sum() == doctest::Approx(108).epsilon(1e-12));
}

TEST_CASE("Neumann and Robin loads sum up to the flux through their side") {
  const demo::AdmissibleMesh made = demo::admissible_mesh(two_materials_pslg(), 0.3);
  demo::PoissonProblem problem;
  problem.diffusion = {1, 1};
  problem.source.resize(2);
  problem.neumann = {{part({below}), [](Point p) { return p.x * p.x; }}};  // 8/3
  problem.robin = {{part({right}), 3.0, [](Point p) { return p.y; }}};     // 3/2
  for (const demo::LinearSystem& system :
       {demo::assemble_fe(made.mesh, problem), demo::assemble_fv(made.mesh, made.boxes, problem)}) {
    CHECK(system.b.sum() == doctest::Approx(8.0 / 3 + 1.5).epsilon(1e-12));
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(system.K.rows());
    CHECK(ones.dot(system.K * ones) == doctest::Approx(3.0).epsilon(1e-12));
  }
}
