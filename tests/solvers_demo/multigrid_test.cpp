#include "multigrid.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "adaptive_problems.hpp"
#include "cross_points.hpp"
#include "estimator.hpp"
#include "lepp/bisection/vertices_made.hpp"
#include "poisson_fe.hpp"
#include "support/random.hpp"

using namespace lepp;
using namespace lepp::demo;

namespace {

/// A forest that was refined for a problem, and the system on its mesh.
struct Case {
  AdaptiveProblem problem;
  Forest forest;
  std::vector<NewVertex> made;
  LinearSystem system;
  std::vector<char> free;
  Eigen::VectorXd zero;  // at free vertices

  explicit Case(const std::string& name, BisectionRule rule = BisectionRule::longest_edge)
      : problem(adaptive_problem(name)), forest(problem.start, rule) {}

  void refine(std::size_t vertices, double theta) {
    while (forest.mesh().vertex_count() < vertices) {
      assemble();
      const Eigen::VectorXd u = solve(forest.mesh(), problem.problem, system).u;
      const Refinement done = forest.bisect(
          largest_indicators(residual_indicators(forest.mesh(), problem.problem, u), theta));
      made.insert(made.end(), done.vertices.begin(), done.vertices.end());
    }
    assemble();
  }

  void assemble() {
    system = assemble_fe(forest.mesh(), problem.problem);
    const auto fixed = fixed_values(forest.mesh(), problem.problem);
    free.assign(fixed.size(), 1);
    zero.setZero(static_cast<Eigen::Index>(fixed.size()));
    for (std::size_t v = 0; v < fixed.size(); ++v) {
      if (!fixed[v]) continue;
      free[v] = 0;
      zero[static_cast<Eigen::Index>(v)] = fixed[v]->value;
    }
  }

  SparseMatrix modes() const {
    return cross_point_modes(forest.mesh(), problem.problem.diffusion, free);
  }

  Eigen::VectorXd noise(test::Random& random) const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(zero.size());
    for (Eigen::Index v = 0; v < x.size(); ++v) {
      if (free[static_cast<std::size_t>(v)] != 0) x[v] = random.real(-1, 1);
    }
    return x;
  }
};

}  // namespace

TEST_CASE("multigrid: as many iterations on small and on large meshes, uniform or graded") {
  for (const double theta : {0.5, 1.0}) {
    for (const std::string name : {"l-shape", "front", "peak"}) {
      CAPTURE(theta);
      CAPTURE(name);
      Case one(name);
      for (const std::size_t vertices : {500U, 3000U, 10000U}) {
        CAPTURE(vertices);
        one.refine(vertices, theta);
        const Multigrid multigrid(one.system.K, one.free, one.made);
        const auto solution = solve_iteratively(one.system, one.free, multigrid, one.zero);
        CHECK(solution.converged);
        CHECK(solution.iterations <= 10);
        if (vertices > 3000) continue;
        const Eigen::VectorXd direct = solve(one.forest.mesh(), one.problem.problem, one.system).u;
        CHECK((solution.u - direct).cwiseAbs().maxCoeff() < 1e-6);
      }
    }
  }
}

TEST_CASE("multigrid on a checkerboard of 161 : 1: as many iterations, also graded to one point") {
  for (const double theta : {0.5, 1.0}) {
    Case one("kellogg");
    for (const std::size_t vertices : {500U, 5000U}) {
      CAPTURE(theta);
      CAPTURE(vertices);
      one.refine(vertices, theta);
      const Multigrid multigrid(one.system.K, one.free, one.made, one.modes());
      const auto solution = solve_iteratively(one.system, one.free, multigrid, one.zero);
      CHECK(solution.converged);
      CHECK(solution.iterations <= 9);
      const Eigen::VectorXd direct = solve(one.forest.mesh(), one.problem.problem, one.system).u;
      CHECK((solution.u - direct).cwiseAbs().maxCoeff() < 1e-6);
      if (theta < 1) CHECK(multigrid.levels() > (vertices < 5000 ? 20 : 40));
    }
  }
}

TEST_CASE("multigrid is a symmetric positive definite map, 0 at given values") {
  test::Random random(3);
  for (const BisectionRule rule : {BisectionRule::longest_edge, BisectionRule::newest_vertex}) {
    Case one("kellogg", rule);
    one.refine(400, 0.6);
    const Multigrid multigrid(one.system.K, one.free, one.made, one.modes());
    Eigen::VectorXd Br, Bs;
    for (int i = 0; i < 20; ++i) {
      const Eigen::VectorXd r = one.noise(random), s = one.noise(random);
      multigrid.apply(r, Br);
      multigrid.apply(s, Bs);
      CHECK(r.dot(Bs) == doctest::Approx(s.dot(Br)));
      CHECK(r.dot(Br) > 0);
      for (std::size_t v = 0; v < one.free.size(); ++v) {
        if (one.free[v] == 0) REQUIRE(Br[static_cast<Eigen::Index>(v)] == 0);
      }
    }
  }
}

TEST_CASE("with a single vertex more than the roots have, one cycle is exact") {
  // All corners of the square are given, so that the vertex of its diagonal is the only unknown.
  Case one("peak");
  one.refine(5, 1);
  REQUIRE(one.forest.mesh().vertex_count() == 5);
  const Multigrid multigrid(one.system.K, one.free, one.made);
  Eigen::VectorXd z;
  const Eigen::VectorXd r = Eigen::VectorXd::Unit(5, 4);
  multigrid.apply(r, z);
  CHECK(z[4] == doctest::Approx(1 / one.system.K.coeff(4, 4)));
}

TEST_CASE("a forest tells in which order its vertices can be made, also after coarsening") {
  Case one("l-shape");
  one.refine(3000, 0.5);
  std::vector<TriangleId> half;
  for (std::size_t t = 0; t < one.forest.mesh().triangle_count() / 2; ++t) half.emplace_back(t);
  for (int i = 0; i < 3; ++i) {
    if (i > 0) {  // ids have moved: what bisect() returned no longer tells
      std::erase_if(half,
                    [&](TriangleId t) { return t.index() >= one.forest.mesh().triangle_count(); });
      REQUIRE(!one.forest.coarsen(half).vertices.empty());
      one.forest.bisect(std::vector{TriangleId(5U), TriangleId(50U)});
      one.assemble();
    }
    const std::vector<NewVertex> made = vertices_made(one.forest);
    CHECK(made.size() + one.forest.root_vertex_count() == one.forest.mesh().vertex_count());
    for (const auto& [v, a, b] : made) {
      const Point middle = midpoint(one.forest.mesh().point(a), one.forest.mesh().point(b));
      REQUIRE(one.forest.mesh().point(v) == middle);
    }
    const Multigrid multigrid(one.system.K, one.free, made);
    const auto solution = solve_iteratively(one.system, one.free, multigrid, one.zero);
    CHECK(solution.converged);
    CHECK(solution.iterations <= 10);
    if (i > 0) continue;
    const Multigrid from_log(one.system.K, one.free, one.made);
    CHECK(from_log.levels() == multigrid.levels());
    CHECK(solve_iteratively(one.system, one.free, from_log, one.zero).iterations ==
          solution.iterations);
  }
}

TEST_CASE("the solution itself is a start that needs no iteration") {
  Case one("front");
  one.refine(1000, 0.5);
  const Multigrid multigrid(one.system.K, one.free, one.made);
  const Eigen::VectorXd direct = solve(one.forest.mesh(), one.problem.problem, one.system).u;
  CHECK(solve_iteratively(one.system, one.free, multigrid, direct).iterations == 0);
}
