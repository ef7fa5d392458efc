#include "poisson_fe.hpp"

#include <doctest/doctest.h>

#include "../support/hand_made.hpp"
#include "lepp/geometry/error.hpp"
#include "two_materials.hpp"

using namespace lepp;
using namespace lepp::test;

TEST_CASE("the stiffness of the unit square's two triangles is the one of the textbook") {
  const Eigen::MatrixXd K = demo::fe_stiffness(square(), {2.0});
  Eigen::MatrixXd expected(4, 4);
  expected << 1, -0.5, 0, -0.5,  //
      -0.5, 1, -0.5, 0,          //
      0, -0.5, 1, -0.5,          //
      -0.5, 0, -0.5, 1;
  CHECK((K - 2 * expected).norm() < 1e-15);
}

TEST_CASE("finite elements: rows of the stiffness sum to zero and it is symmetric") {
  const Mesh mesh = grid({.columns = 8, .rows = 6, .jitter = 0.15, .regions = 2});
  const demo::SparseMatrix K = demo::fe_stiffness(mesh, {1, 50});
  const auto ones = Eigen::VectorXd::Ones(K.rows());
  CHECK((K * ones).norm() < 1e-13 * K.norm());
  const demo::SparseMatrix transposed = K.transpose();
  CHECK((K - transposed).norm() == 0);
}

TEST_CASE("finite elements reproduce a piecewise linear solution over a jump of 1e4") {
  for (const double jump : {1.0, 1e4, 1e-4}) {
    CAPTURE(jump);
    const demo::AdmissibleMesh made = demo::admissible_mesh(two_materials_pslg(), 0.2);
    const demo::Solution solution = demo::solve_fe(made.mesh, linear_problem(jump));
    CHECK(relative_error(made.mesh, solution.u, linear_solution(jump).exact().value) < 1e-9);
  }
}

TEST_CASE("finite elements: what flows in equals what is drained") {
  const demo::AdmissibleMesh made = demo::admissible_mesh(two_materials_pslg(), 0.2);
  demo::PoissonProblem problem;
  problem.diffusion = {1, 3};
  problem.source.assign(2, [](Point) { return -5.0; });  // 5 per area, area 2
  problem.dirichlet = {{part({left}), [](Point) { return 1.0; }},
                       {part({right}), [](Point) { return 2.0; }}};
  const demo::Solution solution = demo::solve_fe(made.mesh, problem);
  REQUIRE(solution.inflow.size() == 2);
  CHECK(solution.inflow[0] + solution.inflow[1] == doctest::Approx(10).epsilon(1e-10));
}

TEST_CASE("without Dirichlet or Robin the problem is refused, naming a place") {
  const Mesh mesh = square();
  demo::PoissonProblem problem;
  problem.diffusion = {1};
  problem.source.resize(1);
  CHECK_THROWS_WITH_AS(demo::solve_fe(mesh, problem), doctest::Contains("no Dirichlet or Robin"),
                       InputError);
}

TEST_CASE("a second component without a condition is refused too") {
  demo::Drawing draw("two squares");
  const auto box = [&](const std::string& name, double x) {
    const VertexId a = draw.point({x, 0}), b = draw.point({x + 1, 0}), c = draw.point({x + 1, 1}),
                   d = draw.point({x, 1});
    const CurveId curve = draw.curve(name, {a, b, c, d, a});
    draw.surface(name + " inside", {x + 0.5, 0.5});
    return curve;
  };
  const CurveId first = box("first", 0);
  const CurveId second = box("second", 3);
  const demo::AdmissibleMesh made = demo::admissible_mesh(draw.pslg(), 1);
  demo::PoissonProblem problem;
  problem.diffusion = {1, 1};
  problem.source.resize(2);
  const demo::Field one = [](Point) { return 1.0; };
  problem.dirichlet = {{{"first", {first}, {}}, one}};
  CHECK_THROWS_WITH_AS(demo::solve_fe(made.mesh, problem), doctest::Contains("(3, 0)"), InputError);
  problem.robin = {{{"second", {second}, {}}, 1.0, one}};
  CHECK(relative_error(made.mesh, demo::solve_fe(made.mesh, problem).u, one) < 1e-12);
}

TEST_CASE("where two Dirichlet conditions meet the first one holds") {
  const demo::AdmissibleMesh made = demo::admissible_mesh(two_materials_pslg(), 1);
  demo::PoissonProblem problem;
  problem.diffusion = {1, 1};
  problem.source.resize(2);
  problem.dirichlet = {{part({left}), [](Point) { return 1.0; }},
                       {part({below}), [](Point) { return 2.0; }}};
  const demo::Solution solution = demo::solve_fe(made.mesh, problem);
  for (std::size_t v = 0; v < made.mesh.vertex_count(); ++v) {
    const Point p = made.mesh.points()[v];
    if (p == Point{0, 0}) CHECK(solution.u[static_cast<Eigen::Index>(v)] == 1);
    if (p == Point{2, 0}) CHECK(solution.u[static_cast<Eigen::Index>(v)] == 2);
  }
}
