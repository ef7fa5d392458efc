#include <array>
#include <cmath>

#include "adaptive_problems.hpp"
#include "estimator.hpp"
#include "lepp/geometry/triangle_measures.hpp"
#include "triangle_rule.hpp"

namespace lepp::demo {
namespace {

// Gauss points and weights on (0, 1).
struct GaussPoint {
  double at, weight;
};

std::array<GaussPoint, 8> gauss_rule() {
  constexpr std::array<double, 4> x = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                       0.9602898564975363};
  constexpr std::array<double, 4> w = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                       0.1012285362903763};
  std::array<GaussPoint, 8> rule{};
  for (std::size_t i = 0; i < 4; ++i) {
    rule[2 * i] = {0.5 - x[i] / 2, w[i] / 2};
    rule[2 * i + 1] = {0.5 + x[i] / 2, w[i] / 2};
  }
  return rule;
}

/// Integral over the triangle (tip, a, b) of a function that near the tip behaves like
/// r^(2 exponent - 2): points are tip + s (a + t (b - a) - tip) with s = q^(1 / exponent), so that
/// what is integrated over q and t is smooth.
template <class Function>
double integral_near_tip(Point tip, Point a, Point b, double exponent, Function f) {
  static const auto rule = gauss_rule();
  const double m = 1 / exponent, area = signed_area(tip, a, b);
  double sum = 0;
  for (const auto& [q, weight_q] : rule) {
    const double s = std::pow(q, m), stretch = m * s / q;  // ds / dq
    for (const auto& [t, weight_t] : rule) {
      const Point p = tip + s * (a + t * (b - a) - tip);
      sum += weight_q * weight_t * 2 * area * s * stretch * f(p);
    }
  }
  return sum;
}

}  // namespace

double energy_error(const Mesh& mesh, const Eigen::VectorXd& u, const AdaptiveProblem& problem) {
  const std::vector<Point> gradient = gradients(mesh, u);
  double sum = 0;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const TriangleId t(i);
    const auto x = mesh.corners(t);
    const auto squared = [&](Point p) {
      const Point off = gradient[i] - problem.exact.gradient(p);
      return dot(off, off);
    };
    std::uint32_t tip = 0;
    while (tip < 3 && !(problem.singular && x[tip] == problem.singular->at)) ++tip;
    const double part =
        tip == 3 ? integral(x, squared)
                 : integral_near_tip(x[tip], x[next_corner(tip)], x[previous_corner(tip)],
                                     problem.singular->exponent, squared);
    sum += problem.problem.diffusion[mesh.region(t).index()] * part;
  }
  return std::sqrt(sum);
}

}  // namespace lepp::demo
