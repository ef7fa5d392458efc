#include "linear_system.hpp"

#include <doctest/doctest.h>

#include "lepp/geometry/error.hpp"
#include "poisson_fe.hpp"
#include "poisson_fv.hpp"
#include "two_materials.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

demo::PoissonProblem held_left() {
  demo::PoissonProblem problem;
  problem.diffusion = {1, 1};
  problem.source.resize(2);
  problem.dirichlet = {{part({left}), [](Point) { return 0.0; }}};
  return problem;
}

}  // namespace

TEST_CASE("a matrix that is not positive definite is refused") {
  const demo::AdmissibleMesh made = demo::admissible_mesh(two_materials_pslg(), 0.5);
  const demo::PoissonProblem problem = held_left();
  demo::LinearSystem system = demo::assemble_fe(made.mesh, problem);
  CHECK_NOTHROW(demo::solve(made.mesh, problem, system));
  system.K *= -1;
  CHECK_THROWS_WITH_AS(demo::solve(made.mesh, problem, system),
                       doctest::Contains("not positive definite"), InputError);
}

TEST_CASE("a flux on an interior curve enters once, not once per side") {
  const demo::AdmissibleMesh made = demo::admissible_mesh(two_materials_pslg(), 0.3);
  demo::PoissonProblem problem = held_left();
  problem.neumann = {{part({4}), [](Point) { return 2.0; }}};  // the interface
  const double entering = 2 * std::hypot(1.0, 0.3);
  CHECK(demo::solve_fe(made.mesh, problem).inflow[0] == doctest::Approx(-entering).epsilon(1e-10));
  CHECK(demo::solve_fv(made.mesh, made.boxes, problem).inflow[0] ==
        doctest::Approx(-entering).epsilon(1e-10));
}
