#include "convergence.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "poisson_fe.hpp"

using namespace lepp;
using namespace lepp::demo;

TEST_CASE("both methods converge with the right orders on two materials with a hole") {
  const Convergence convergence = run_convergence(two_materials_with_hole(), {0.1, 4});
  REQUIRE(convergence.levels.size() == 4);
  CHECK(convergence.orders.fe_l2 >= 1.95);
  CHECK(convergence.orders.fe_h1 >= 0.97);
  CHECK(convergence.orders.fv_l2 >= 1.9);
  // A rate alone also passes when every error is ten times too big.
  CHECK(convergence.levels.back().h == 0.0125);
  CHECK(convergence.levels.back().fe_l2 < 1e-3);
  CHECK(convergence.levels.back().fe_h1 < 0.1);
  CHECK(convergence.levels.back().fv_l2 < 1e-3);
}

TEST_CASE("each level halves h and asks for a mesh of its own") {
  std::vector<double> longest;
  run_convergence(two_materials_with_hole(), {0.2, 3},
                  [&](const ConvergenceLevel& level, const AdmissibleMesh& made, const Solution&,
                      const Solution&) {
                    double squared = 0;
                    for (const Triangle& t : made.mesh.triangles()) {
                      for (std::uint32_t i = 0; i < 3; ++i) {
                        squared = std::max(
                            squared, squared_distance(made.mesh.point(t.vertices[i]),
                                                      made.mesh.point(t.vertices[next_corner(i)])));
                      }
                    }
                    CHECK(std::sqrt(squared) <= level.h * (1 + 1e-12));
                    longest.push_back(level.h);
                  });
  CHECK(longest == std::vector<double>{0.2, 0.1, 0.05});
}

TEST_CASE("observed_order is the slope of a power law, over the last three levels") {
  CHECK(observed_order({100, 400, 1600, 6400}, {7, 1.0, 0.25, 0.0625}) == doctest::Approx(2.0));
  CHECK(observed_order({100, 400, 1600}, {1, 0.5, 0.25}) == doctest::Approx(1.0));
}

TEST_CASE("the error norms of the zero function are the norms of the exact solution") {
  const SolvedProblem solved = two_materials_with_hole();
  const AdmissibleMesh made = admissible_mesh(solved.pslg, 0.05);
  const ExactSolution linear{[](Point p) { return p.x; }, [](Point) { return Point{1, 0}; }};
  const Eigen::VectorXd zero =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(made.mesh.vertex_count()));
  // The rectangle less the hexagon (area 3 sqrt(3)/2 r^2, around x = 0.5), integrated by hand.
  const double r = 0.22, hole = 1.5 * std::sqrt(3.0) * r * r;
  const double inertia = 5 * std::sqrt(3.0) / 16 * std::pow(r, 4);
  const double squared = 8.0 / 3 - (0.25 * hole + inertia);
  const ErrorNorms norms = error_norms(made.mesh, zero, linear);
  CHECK(norms.l2 == doctest::Approx(std::sqrt(squared)).epsilon(1e-12));
  CHECK(norms.h1 == doctest::Approx(std::sqrt(squared + 2 - hole)).epsilon(1e-12));
}
