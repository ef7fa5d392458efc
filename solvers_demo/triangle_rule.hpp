#pragma once

#include <array>
#include <cmath>

#include "lepp/geometry/point.hpp"
#include "lepp/geometry/triangle_measures.hpp"

namespace lepp::demo {

struct QuadraturePoint {
  std::array<double, 3> at;  ///< barycentric
  double weight;             ///< of the area
};

/// Radon's rule: the centroid and two orbits of three points. Exact for degree 5.
inline const std::array<QuadraturePoint, 7>& radon_rule() {
  static const auto rule = [] {
    const double root = std::sqrt(15.0);
    std::array<QuadraturePoint, 7> made{};
    made[0] = {{1.0 / 3, 1.0 / 3, 1.0 / 3}, 9.0 / 40};
    for (std::size_t i = 0; i < 3; ++i) {
      const double near = (6 + root) / 21, far = (6 - root) / 21;
      made[1 + i] = {{near, near, near}, (155 + root) / 1200};
      made[1 + i].at[i] = 1 - 2 * near;
      made[4 + i] = {{far, far, far}, (155 - root) / 1200};
      made[4 + i].at[i] = 1 - 2 * far;
    }
    return made;
  }();
  return rule;
}

/// The integral of f over the triangle with corners x, by that rule.
template <class Function>
double integral(const std::array<Point, 3>& x, Function f) {
  double sum = 0;
  for (const auto& [at, weight] : radon_rule()) {
    sum += weight * f(at[0] * x[0] + at[1] * x[1] + at[2] * x[2]);
  }
  return signed_area(x[0], x[1], x[2]) * sum;
}

}  // namespace lepp::demo
