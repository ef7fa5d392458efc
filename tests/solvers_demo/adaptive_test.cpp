#include "adaptive.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "lepp/voronoi/admissible.hpp"

using namespace lepp;
using namespace lepp::demo;

namespace {

/// The error at a number of vertices, interpolated between steps in logarithms.
double error_at(const std::vector<AdaptiveStep>& steps, double vertices) {
  std::size_t i = 1;
  while (static_cast<double>(steps.at(i).vertices) < vertices) ++i;
  const auto x = [&](std::size_t k) { return std::log(static_cast<double>(steps[k].vertices)); };
  const double part = (std::log(vertices) - x(i - 1)) / (x(i) - x(i - 1));
  return std::exp((1 - part) * std::log(steps[i - 1].error) + part * std::log(steps[i].error));
}

double rate(const std::vector<AdaptiveStep>& steps, double AdaptiveStep::*quantity) {
  const auto observed = observed_rate(steps, quantity);
  REQUIRE(observed);
  return *observed;
}

}  // namespace

TEST_CASE("a rate needs two numbers of unknowns that are at most tenfold apart") {
  std::vector<AdaptiveStep> steps;
  CHECK_FALSE(observed_rate(steps, &AdaptiveStep::error));
  const auto add = [&](std::size_t unknowns, double error) {
    steps.emplace_back();
    steps.back().unknowns = unknowns;
    steps.back().error = error;
  };
  add(0, 3);
  CHECK_FALSE(observed_rate(steps, &AdaptiveStep::error));
  add(3, 2);
  CHECK_FALSE(observed_rate(steps, &AdaptiveStep::error));
  add(100, 2);
  CHECK_FALSE(observed_rate(steps, &AdaptiveStep::error));
  add(400, 1);
  CHECK(rate(steps, &AdaptiveStep::error) == doctest::Approx(0.5));
}

// Figures of another program for the same loop, which integrates by the centroids of 16 parts:
// 8.07e-3 at 10701 vertices and 4.58e-3 at 32682, and 2.401e-2 at 24833 on uniform meshes.
TEST_CASE("L-shape: known errors are met, at rates -1/2 and, uniformly, -1/3") {
  AdaptiveOptions options;
  options.error_quadrature = ErrorQuadrature::centroids;
  options.max_unknowns = 32100;
  const auto adaptive = run_adaptive(l_shape(), options);
  CHECK(error_at(adaptive, 10701) == doctest::Approx(8.07e-3).epsilon(0.001));
  CHECK(error_at(adaptive, 32682) == doctest::Approx(4.58e-3).epsilon(0.001));
  CHECK(rate(adaptive, &AdaptiveStep::error) == doctest::Approx(0.5).epsilon(0.013));
  for (const AdaptiveStep& step : adaptive) CHECK(step.min_angle_deg > 44.99);

  options.theta = 1;
  options.max_unknowns = 24000;
  const auto uniform = run_adaptive(l_shape(), options);
  CHECK(uniform.back().vertices == 24833);
  CHECK(uniform.back().error == doctest::Approx(2.401e-2).epsilon(0.001));
  CHECK(rate(uniform, &AdaptiveStep::error) == doctest::Approx(1.0 / 3).epsilon(0.015));

  options.error_quadrature = ErrorQuadrature::graded;  // the true error is larger by 5.5 %
  const auto truly = run_adaptive(l_shape(), options);
  CHECK(truly.back().error == doctest::Approx(2.533e-2).epsilon(0.001));
  CHECK(rate(truly, &AdaptiveStep::error) == doctest::Approx(1.0 / 3).epsilon(0.015));
}

TEST_CASE("both estimators lead to the best rate where the difficulty is local") {
  for (const Estimator estimator : {Estimator::residual, Estimator::zz}) {
    for (const std::string name : {"l-shape", "front", "peak"}) {
      CAPTURE(name);
      AdaptiveOptions options;
      options.estimator = estimator;
      options.max_unknowns = 5000;
      const auto steps = run_adaptive(adaptive_problem(name), options);
      CHECK(rate(steps, &AdaptiveStep::error) > 0.48);
      const double quotient = steps.back().estimate / steps.back().error;
      if (estimator == Estimator::zz) CHECK(quotient == doctest::Approx(1).epsilon(0.02));
      else CHECK((quotient > 1 && quotient < 7));
    }
  }
}

TEST_CASE("checkerboard: the loop refines towards the point where materials meet") {
  AdaptiveOptions options;
  options.max_unknowns = 4000;
  const auto adaptive = run_adaptive(kellogg(), options);
  options.theta = 1;
  const auto uniform = run_adaptive(kellogg(), options);
  CHECK(rate(uniform, &AdaptiveStep::error) < 0.1);  // tends to gamma / 2
  CHECK(rate(adaptive, &AdaptiveStep::error) > 0.38);
  CHECK(adaptive.back().error < 0.25 * uniform.back().error);
  CHECK(adaptive.back().iterations <= 6);
}

TEST_CASE("by delaunay: every mesh is admissible, and the error falls as fast") {
  for (const std::string name : {"l-shape", "front", "peak", "kellogg"}) {
    CAPTURE(name);
    const AdaptiveProblem problem = adaptive_problem(name);
    AdaptiveOptions options;
    options.by = RefineBy::delaunay;
    options.max_unknowns = 1000;
    const auto steps = run_adaptive(
        problem, options,
        [&](const AdaptiveStep& step, const Mesh& mesh, const Eigen::VectorXd& u, const auto&) {
          CAPTURE(step.vertices);
          CHECK(certify(mesh).admissible);
          CHECK(step.min_angle_deg >= 30 - 1e-9);
          CHECK(static_cast<std::size_t>(u.size()) == mesh.vertex_count());
        });
    CHECK(steps.size() > 10);
    CHECK(rate(steps, &AdaptiveStep::error) > (name == "kellogg" ? 0.35 : 0.48));
  }
}

TEST_CASE("by delaunay: where edges cannot be shorter, the loop ends with what it has") {
  AdaptiveProblem far = kellogg();  // so far out that edges end at 0.06
  for (std::size_t v = 0; v < far.start.vertex_count(); ++v) {
    far.start.move_vertex(VertexId(v), far.start.points()[v] + Point{0x1p+40, 0});
  }
  AdaptiveOptions options;
  options.by = RefineBy::delaunay;
  options.theta = 0.5;
  options.max_unknowns = 100000;
  const auto steps = run_adaptive(far, options);
  CHECK(steps.size() > 5);
  CHECK(steps.back().unknowns < 5000);
  CHECK(steps.back().min_angle_deg >= 30 - 1e-9);
}

TEST_CASE("the direct solver gives the same errors") {  // ties in marking may be broken otherwise
  AdaptiveOptions options;
  options.max_unknowns = 2000;
  const auto multigrid = run_adaptive(gaussian_peak(), options);
  options.solver = LinearSolver::direct;
  const auto direct = run_adaptive(gaussian_peak(), options);
  for (const double vertices : {200.0, 500.0, 1500.0}) {
    CHECK(error_at(direct, vertices) ==
          doctest::Approx(error_at(multigrid, vertices)).epsilon(0.02));
  }
}

TEST_CASE("each solution starts from the last one: fewer iterations than from zero") {
  AdaptiveOptions options;
  options.max_unknowns = 5000;
  std::size_t most = 0;
  for (const AdaptiveStep& step : run_adaptive(l_shape(), options)) {
    most = std::max(most, step.iterations);
  }
  CHECK(most <= 6);
  CHECK(most > 0);
}

TEST_CASE("by delaunay multigrid keeps its iterations where few vertices make edges very short") {
  AdaptiveOptions options;
  options.by = RefineBy::delaunay;
  options.estimator = Estimator::zz;
  options.theta = 0.1;
  options.max_unknowns = 700;  // edges of 1e-10; 16 iterations where meshes are told by size alone
  for (const AdaptiveStep& step : run_adaptive(adaptive_problem("kellogg"), options)) {
    CAPTURE(step.unknowns);
    CHECK(step.iterations <= 10);
  }
}
