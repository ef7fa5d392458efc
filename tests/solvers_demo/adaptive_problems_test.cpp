#include "adaptive_problems.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "lepp/bisection/transfer.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/triangulation/validate.hpp"
#include "poisson_fe.hpp"
#include "support/random.hpp"

using namespace lepp;
using namespace lepp::demo;

namespace {

/// A place strictly inside a random triangle of the start, and the region there.
struct Inside {
  Point p;
  SurfaceId region;
};

Inside inside(const Mesh& mesh, test::Random& random) {
  const TriangleId t(random.below(static_cast<std::uint32_t>(mesh.triangle_count())));
  const auto x = mesh.corners(t);
  const double a = random.real(0.1, 0.5), b = random.real(0.1, 0.4);
  return {a * x[0] + b * x[1] + (1 - a - b) * x[2], mesh.region(t)};
}

std::vector<TriangleId> all_of(const Mesh& mesh) {
  std::vector<TriangleId> all;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) all.emplace_back(t);
  return all;
}

}  // namespace

TEST_CASE("exact solutions: the gradient is that of the value, and -div(D grad u) = f") {
  test::Random random(7);
  for (const std::string& name : adaptive_problem_names()) {
    CAPTURE(name);
    const AdaptiveProblem problem = adaptive_problem(name);
    const auto& u = problem.exact;
    for (int i = 0; i < 200; ++i) {
      const Inside place = inside(problem.start, random);
      const Point p = place.p;
      CAPTURE(p.x);
      CAPTURE(p.y);
      const double h = 1e-5, near = 1e-5;
      const Point g = u.gradient(p);
      const double in_x = (u.value(p + Point{h, 0}) - u.value(p - Point{h, 0})) / (2 * h);
      const double in_y = (u.value(p + Point{0, h}) - u.value(p - Point{0, h})) / (2 * h);
      const double scale = 1 + std::hypot(g.x, g.y);
      CHECK(std::abs(in_x - g.x) < near * scale);
      CHECK(std::abs(in_y - g.y) < near * scale);
      const double divergence = (u.gradient(p + Point{h, 0}).x - u.gradient(p - Point{h, 0}).x +
                                 u.gradient(p + Point{0, h}).y - u.gradient(p - Point{0, h}).y) /
                                (2 * h);
      const double D = problem.problem.diffusion[place.region.index()];
      const Field& f = problem.problem.source[place.region.index()];
      CHECK(std::abs(D * divergence + (f ? f(p) : 0)) < 1e-3 * D * (1 + std::abs(divergence)));
    }
  }
}

TEST_CASE("the checkerboard: the value and the flux are the same on both sides of the axes") {
  const AdaptiveProblem problem = kellogg();
  const auto& u = problem.exact;
  const double high = problem.problem.diffusion[0], low = problem.problem.diffusion[1];
  for (const double r : {1e-9, 0.01, 0.5}) {
    CAPTURE(r);
    const double e = 1e-13 * r, scale = std::pow(r, -0.9);
    for (const double side : {-1.0, 1.0}) {  // of an axis: the material changes across it
      const Point on_x{side * r, e}, below_x{side * r, -e}, on_y{e, side * r}, left_y{-e, side * r};
      const double above = side > 0 ? high : low, below = side > 0 ? low : high;
      CHECK(std::abs(u.value(on_x) - u.value(below_x)) < 1e-9);
      CHECK(std::abs(u.value(on_y) - u.value(left_y)) < 1e-9);
      CHECK(std::abs(above * u.gradient(on_x).y - below * u.gradient(below_x).y) < 1e-9 * scale);
      CHECK(std::abs(above * u.gradient(on_y).x - below * u.gradient(left_y).x) < 1e-9 * scale);
      CHECK(std::abs(u.gradient(on_x).y) > 1e-5 * scale);  // not 0 = 0
    }
  }
}

TEST_CASE("meshes at the start are valid; that of the L-shape has 8 vertices and 6 triangles") {
  for (const std::string& name : adaptive_problem_names()) {
    CAPTURE(name);
    CHECK(validate(adaptive_problem(name).start).summary() == "valid");
  }
  CHECK(l_shape().start.vertex_count() == 8);
  CHECK(l_shape().start.triangle_count() == 6);
  CHECK_THROWS_AS(adaptive_problem("t-shape"), InputError);
}

// Where u is harmonic, |u - w|^2 = integral over the boundary of (u - 2 w) du/dn, plus w^T K w, for
// any w that is linear on triangles: no quadrature at the corner, where du/dn w = 0.
TEST_CASE("the energy error on the L-shape is what Green's formula gives") {
  const AdaptiveProblem problem = l_shape();
  Forest forest(problem.start);
  for (int i = 0; i < 6; ++i) forest.bisect(all_of(forest.mesh()));
  const Mesh& mesh = forest.mesh();
  const Eigen::VectorXd w = solve_fe(mesh, problem.problem).u;
  double squared = w.dot(fe_stiffness(mesh, {1}) * w);
  for (const HalfEdge e : edges_of(mesh, problem.problem.dirichlet[0].part)) {
    const Point a = mesh.point(mesh.origin(e)), along = mesh.point(mesh.destination(e)) - a;
    constexpr int pieces = 400;
    for (int i = 0; i < pieces; ++i) {
      const double s = (i + 0.5) / pieces;
      const Point p = a + s * along;
      const double w_here = (1 - s) * w[mesh.origin(e).value] + s * w[mesh.destination(e).value];
      const double outflow = cross(problem.exact.gradient(p), along);  // du/dn |e|
      squared += (problem.exact.value(p) - 2 * w_here) * outflow / pieces;
    }
  }
  CHECK(energy_error(mesh, w, problem) == doctest::Approx(std::sqrt(squared)).epsilon(1e-4));
}
