#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "lepp/geometry/point.hpp"

namespace lepp {

/// Tests the smallest angle of a triangle against one bound without acos, sqrt or division.
class AngleTest {
 public:
  /// A bound of 0 asks for nothing.
  explicit AngleTest(double min_angle_deg)
      : squared_cos_(min_angle_deg > 0 ? squared_cos(min_angle_deg - forgiven_deg) : 2) {}

  bool is_below(Point a, Point b, Point c) const {
    const Ratio r = squared_cos_of_smallest(a, b, c);
    return r.part > squared_cos_ * r.whole;
  }
  /// cos^2 of the smallest angle: from 1/4 (equilateral) to 1 (flat).
  static double badness(Point a, Point b, Point c) {
    const Ratio r = squared_cos_of_smallest(a, b, c);
    return r.part / r.whole;
  }
  static double squared_cos(double angle_deg) {
    const double cosine = std::cos(angle_deg * std::numbers::pi / 180);
    return cosine * cosine;
  }

 private:
  // Half of what the report forgives, so that rounding never parts the two.
  static constexpr double forgiven_deg = 5e-10;
  struct Ratio {
    double part, whole;
  };
  // The smallest angle faces the shortest edge.
  static Ratio squared_cos_of_smallest(Point a, Point b, Point c) {
    const Point ab = b - a, bc = c - b, ca = a - c;
    const double l_ab = dot(ab, ab), l_bc = dot(bc, bc), l_ca = dot(ca, ca);
    if (l_ab <= l_bc && l_ab <= l_ca) return {squared(dot(bc, ca)), l_bc * l_ca};
    if (l_bc <= l_ca) return {squared(dot(ca, ab)), l_ca * l_ab};
    return {squared(dot(ab, bc)), l_ab * l_bc};
  }
  static double squared(double x) { return x * x; }

  double squared_cos_;
};

}  // namespace lepp
