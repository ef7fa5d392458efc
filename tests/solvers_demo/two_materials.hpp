#pragma once

// Two materials in a rectangle, divided by an oblique interface, for the tests of both methods.

#include "admissible_mesh.hpp"
#include "drawing.hpp"
#include "manufactured.hpp"

namespace lepp::test {

/// d ------ h -- c     a (0, 0)    e (0.9, 0)   b (2, 0)
/// |       /     |     d (0, 1)    h (1.2, 1)   c (2, 1)
/// a ---- e ---- b     groups: below, right, above, left, interface; soft | hard
inline Pslg two_materials_pslg() {
  demo::Drawing draw("two materials");
  const VertexId a = draw.point({0, 0}), b = draw.point({2, 0}), c = draw.point({2, 1}),
                 d = draw.point({0, 1}), e = draw.point({0.9, 0}), h = draw.point({1.2, 1});
  draw.curve("below", {a, e, b});
  draw.curve("right", {b, c});
  draw.curve("above", {c, h, d});
  draw.curve("left", {d, a});
  draw.curve("interface", {e, h});
  draw.surface("soft", {0.1, 0.5});
  draw.surface("hard", {1.9, 0.5});
  return draw.pslg();
}

inline constexpr std::uint32_t below = 0, right = 1, above = 2, left = 3;

inline demo::BoundaryPart part(std::initializer_list<std::uint32_t> curves) {
  demo::BoundaryPart result{"part", {}, {}};
  for (const std::uint32_t c : curves) result.curves.emplace_back(c);
  return result;
}

/// Piecewise linear across the interface, which conducts `jump` times better on the right.
inline demo::PiecewiseLinear linear_solution(double jump) {
  const double length = std::hypot(1.0, 0.3);
  return {{{0.9, 0}, {1 / length, -0.3 / length}, {1, jump}}};
}

/// The problem that linear_solution(jump) solves: every kind of condition on its own side.
inline demo::PoissonProblem linear_problem(double jump) {
  const demo::PiecewiseLinear u = linear_solution(jump);
  demo::PoissonProblem problem;
  problem.diffusion = {1, jump};
  problem.source.resize(2);
  problem.dirichlet = {{part({left, above}), u.exact().value}};
  problem.neumann = {{part({below}), [u](Point p) { return u.flux(p, {0, -1}); }}};
  problem.robin = {{part({right}), 7.0, [u](Point p) {
                      return u.value(p) + u.flux(p, {1, 0}) / 7.0;
                    }}};
  return problem;
}

/// Largest difference at a vertex, relative to the largest value.
inline double relative_error(const Mesh& mesh, const Eigen::VectorXd& u, const demo::Field& exact) {
  double error = 0, size = 0;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const double value = exact(mesh.points()[v]);
    error = std::max(error, std::abs(u[static_cast<Eigen::Index>(v)] - value));
    size = std::max(size, std::abs(value));
  }
  return error / size;
}

}  // namespace lepp::test
