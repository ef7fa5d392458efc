#include "error_norms.hpp"

#include <array>
#include <cmath>

#include "lepp/geometry/triangle_measures.hpp"
#include "triangle_rule.hpp"

namespace lepp::demo {
namespace {

/// Gradient of the linear function with values u at the corners x.
Point gradient_of(const std::array<Point, 3>& x, const std::array<double, 3>& u) {
  const Point a = x[1] - x[0], b = x[2] - x[0];
  const double ua = u[1] - u[0], ub = u[2] - u[0];
  const double scale = 1 / cross(a, b);
  return {scale * (ua * b.y - ub * a.y), scale * (ub * a.x - ua * b.x)};
}

}  // namespace

ErrorNorms error_norms(const Mesh& mesh, const Eigen::VectorXd& u, const ExactSolution& exact) {
  const auto& rule = radon_rule();
  double squared_value = 0, squared_gradient = 0;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const TriangleId t(i);
    const auto x = mesh.corners(t);
    std::array<double, 3> corner{};
    for (std::uint32_t k = 0; k < 3; ++k) corner[k] = u[mesh.vertex(t, k).value];
    const Point gradient = gradient_of(x, corner);
    const double area = signed_area(x[0], x[1], x[2]);
    for (const auto& [at, weight] : rule) {
      const Point p = at[0] * x[0] + at[1] * x[1] + at[2] * x[2];
      const double value = at[0] * corner[0] + at[1] * corner[1] + at[2] * corner[2];
      squared_value += area * weight * std::pow(value - exact.value(p), 2);
      if (!exact.gradient) continue;
      const Point off = gradient - exact.gradient(p);
      squared_gradient += area * weight * dot(off, off);
    }
  }
  return {std::sqrt(squared_value), std::sqrt(squared_value + squared_gradient)};
}

}  // namespace lepp::demo
