#include "remesh_multigrid.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "adaptive.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/voronoi/voronoi_boxes.hpp"
#include "poisson_fe.hpp"
#include "poisson_fv.hpp"
#include "support/random.hpp"

using namespace lepp;
using namespace lepp::demo;

namespace {

/// The L-shape, meshed anew for each longest edge, and the system on the last mesh.
struct Remeshed {
  AdaptiveProblem problem = l_shape();
  MeshHistory history;
  Mesh mesh;
  std::vector<char> free;
  Eigen::VectorXd zero;
  LinearSystem system;

  explicit Remeshed(const std::vector<double>& edges) {
    for (const double edge : edges) {
      if (!free.empty()) history.add(mesh, free);
      mesh = problem.start;
      REQUIRE(refine(mesh, {.max_edge = edge}).goal_reached);
      const auto fixed = fixed_values(mesh, problem.problem);
      free.assign(fixed.size(), 1);
      zero.setZero(static_cast<Eigen::Index>(fixed.size()));
      for (std::size_t v = 0; v < fixed.size(); ++v) {
        if (!fixed[v]) continue;
        free[v] = 0;
        zero[static_cast<Eigen::Index>(v)] = fixed[v]->value;
      }
    }
    system = assemble_fv(mesh, voronoi_boxes(mesh), problem.problem);
  }

  RemeshMultigrid multigrid() const {
    return RemeshMultigrid(system.K, free, history.interpolations(mesh, free));
  }
};

}  // namespace

TEST_CASE("multigrid over meshes that are not nested: as many iterations, the direct solution") {
  for (const std::vector<double>& edges :
       {std::vector<double>{0.5, 0.2}, {0.5, 0.2, 0.1, 0.05}, {0.5, 0.2, 0.1, 0.05, 0.025}}) {
    const Remeshed one(edges);
    const RemeshMultigrid multigrid = one.multigrid();
    CHECK(multigrid.levels() == edges.size());
    const auto solution = solve_iteratively(one.system, one.free, multigrid, one.zero);
    CHECK(solution.converged);
    CHECK(solution.iterations <= 12);
    const Eigen::VectorXd direct = solve(one.mesh, one.problem.problem, one.system).u;
    CHECK((solution.u - direct).cwiseAbs().maxCoeff() < 1e-6);
  }
}

TEST_CASE("multigrid over meshes that are not nested is symmetric, 0 at given values") {
  const Remeshed one({0.5, 0.2, 0.1});
  const RemeshMultigrid multigrid = one.multigrid();
  test::Random random(5);
  const auto noise = [&] {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(one.zero.size());
    for (Eigen::Index v = 0; v < x.size(); ++v) {
      if (one.free[static_cast<std::size_t>(v)] != 0) x[v] = random.real(-1, 1);
    }
    return x;
  };
  for (int i = 0; i < 10; ++i) {
    const Eigen::VectorXd r = noise(), s = noise();
    Eigen::VectorXd Br, Bs;
    multigrid.apply(r, Br);
    multigrid.apply(s, Bs);
    CHECK(r.dot(Bs) == doctest::Approx(s.dot(Br)));
    CHECK(r.dot(Br) > 0);
    for (std::size_t v = 0; v < one.free.size(); ++v) {
      if (one.free[v] == 0) REQUIRE(Br[static_cast<Eigen::Index>(v)] == 0);
    }
  }
}

TEST_CASE("without an earlier mesh the cycle is a direct solver") {
  const Remeshed one({0.3});
  const RemeshMultigrid multigrid = one.multigrid();
  CHECK(multigrid.levels() == 1);
  CHECK(solve_iteratively(one.system, one.free, multigrid, one.zero).iterations <= 1);
}

TEST_CASE("by delaunay each solution starts from the last one, transferred: few iterations") {
  for (const std::string name : {"l-shape", "kellogg"}) {
    CAPTURE(name);
    AdaptiveOptions options;
    options.by = RefineBy::delaunay;
    options.max_unknowns = 1000;
    const auto multigrid = run_adaptive(adaptive_problem(name), options);
    for (const AdaptiveStep& step : multigrid) CHECK(step.iterations <= 10);
    options.solver = LinearSolver::direct;
    const auto direct = run_adaptive(adaptive_problem(name), options);
    CHECK(multigrid.back().error == doctest::Approx(direct.back().error).epsilon(0.05));
  }
}
