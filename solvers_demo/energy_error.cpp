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

/// By the centroids of the parts that three families of parallels, four to a side, cut out.
template <class Function>
double integral_by_centroids(const std::array<Point, 3>& x, Function f) {
  constexpr int n = 4;
  const Point a = (1.0 / n) * (x[1] - x[0]), b = (1.0 / n) * (x[2] - x[0]);
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; i + k < n; ++k) {
      sum += f(x[0] + (i + 1.0 / 3) * a + (k + 1.0 / 3) * b);
      if (i + k + 1 < n) sum += f(x[0] + (i + 2.0 / 3) * a + (k + 2.0 / 3) * b);
    }
  }
  return signed_area(x[0], x[1], x[2]) / (n * n) * sum;
}

/// By Radon's rule, or that of the singular point if it is a corner.
template <class Function>
double graded_integral(const std::array<Point, 3>& x, const std::optional<SingularPoint>& singular,
                       Function f) {
  std::uint32_t tip = 0;
  while (tip < 3 && !(singular && x[tip] == singular->at)) ++tip;
  if (tip == 3) return integral(x, f);
  return integral_near_tip(x[tip], x[next_corner(tip)], x[previous_corner(tip)], singular->exponent,
                           f);
}

}  // namespace

double energy_error(const Mesh& mesh, const Eigen::VectorXd& u, const AdaptiveProblem& problem,
                    ErrorQuadrature quadrature) {
  const std::vector<Point> gradient = gradients(mesh, u);
  double sum = 0;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const TriangleId t(i);
    const auto x = mesh.corners(t);
    const auto squared = [&](Point p) {
      const Point off = gradient[i] - problem.exact.gradient(p);
      return dot(off, off);
    };
    const double part = quadrature == ErrorQuadrature::centroids
                            ? integral_by_centroids(x, squared)
                            : graded_integral(x, problem.singular, squared);
    sum += problem.problem.diffusion[mesh.region(t).index()] * part;
  }
  return std::sqrt(sum);
}

}  // namespace lepp::demo
