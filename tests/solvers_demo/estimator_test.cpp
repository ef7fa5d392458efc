#include "estimator.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "adaptive_problems.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "manufactured.hpp"
#include "support/random.hpp"
#include "two_materials.hpp"

using namespace lepp;
using namespace lepp::demo;

namespace {

double total(const std::vector<double>& indicators) {
  return std::accumulate(indicators.begin(), indicators.end(), 0.0);
}

Eigen::VectorXd values_at(const Mesh& mesh, const Field& u) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(mesh.vertex_count()));
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    values[static_cast<Eigen::Index>(v)] = u(mesh.point(VertexId(v)));
  }
  return values;
}

PoissonProblem without_source(std::vector<double> diffusion) {
  PoissonProblem problem;
  problem.source.resize(diffusion.size());
  problem.diffusion = std::move(diffusion);
  return problem;
}

}  // namespace

TEST_CASE("gradients of a linear function are its gradient") {
  const Mesh mesh = kellogg().start;
  const auto u = values_at(mesh, [](Point p) { return 3 - 2 * p.x + 5 * p.y; });
  for (const Point g : gradients(mesh, u)) {
    CHECK(g.x == doctest::Approx(-2));
    CHECK(g.y == doctest::Approx(5));
  }
}

// u = |x| or |x| / D on the two halves of (-1, 1)^2: a kink at an interface, as it must be or not.
TEST_CASE("estimators see a kink only where the flux jumps") {
  const Mesh mesh = kellogg().start;  // regions: quadrants
  const auto kink = [](double right, double left) {
    return [=](Point p) { return p.x > 0 ? p.x / right : p.x / left; };
  };
  const PoissonProblem jump = without_source({7, 2, 2, 7});
  const auto right = values_at(mesh, kink(7, 2));
  CHECK(total(residual_indicators(mesh, jump, right)) < 1e-25);
  CHECK(total(zz_indicators(mesh, jump, right)) < 1e-25);
  // With one D: across x = 0, |e| = 1 twice, the flux jumps by 5/14; half of it counts on each
  // side.
  const PoissonProblem same = without_source({1, 1, 1, 1});
  CHECK(total(residual_indicators(mesh, same, right)) ==
        doctest::Approx(2 * std::pow(1.0 / 2 - 1.0 / 7, 2)));
  // A smooth u has no jump, wherever D jumps; the flux does.
  const auto smooth = values_at(mesh, [](Point p) { return p.x; });
  CHECK(total(residual_indicators(mesh, jump, smooth)) == doctest::Approx(2 * 25.0 / 7));
}

TEST_CASE("the residual estimator scales like the squared energy norm") {
  const AdaptiveProblem problem = arctan_front();
  PoissonProblem scaled = problem.problem;
  scaled.diffusion[0] = 9;  // with f and u alike the solution is that of f / 9, times 9
  const Mesh& mesh = problem.start;
  const Eigen::VectorXd u = values_at(mesh, problem.exact.value);
  const double one = total(residual_indicators(mesh, problem.problem, u));
  CHECK(total(residual_indicators(mesh, scaled, u / 9)) == doctest::Approx(one / 9));
}

TEST_CASE("marking takes the fewest triangles that have the part asked for") {
  const std::vector<double> indicators = {1, 5, 0, 2, 2};  // sum 10
  const auto marked = [&](double theta) {
    std::vector<std::uint32_t> ids;
    for (const TriangleId t : largest_indicators(indicators, theta)) ids.push_back(t.value);
    return ids;
  };
  CHECK(marked(0.5) == std::vector<std::uint32_t>{1});
  CHECK(marked(0.51) == std::vector<std::uint32_t>{1, 3});
  CHECK(marked(0.9) == std::vector<std::uint32_t>{1, 3, 4});
  CHECK(marked(1).size() == 5);
}
