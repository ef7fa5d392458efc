#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lepp/geometry/point.hpp"
#include "lepp/geometry/predicates.hpp"

namespace lepp {

/// Tests the smallest and the largest angle of a triangle against bounds without acos, sqrt or
/// division.
class AngleTest {
 public:
  /// Bounds of 0 and 180 ask for nothing. \pre max_angle_deg >= 90
  explicit AngleTest(double min_angle_deg, double max_angle_deg = 180)
      : squared_cos_(min_angle_deg > 0 ? squared_cos(min_angle_deg - forgiven_deg) : 2),
        largest_(max_angle_deg),
        squared_cos_of_largest_(squared_cos(max_angle_deg + forgiven_deg)) {}

  bool is_bad(Point a, Point b, Point c) const { return is_below(a, b, c) || is_above(a, b, c); }

  bool is_below(Point a, Point b, Point c) const {
    const Ratio r = squared_cos_of_smallest(a, b, c);
    return r.part > squared_cos_ * r.whole;
  }
  /// Exact where the bound is 90 degrees.
  bool is_above(Point a, Point b, Point c) const {
    if (largest_ >= 180) return false;
    const double l_ab = squared_distance(a, b), l_bc = squared_distance(b, c),
                 l_ca = squared_distance(c, a);
    if (l_ab >= l_bc && l_ab >= l_ca) return is_above_at(a, c, b, l_bc * l_ca);
    if (l_bc >= l_ca) return is_above_at(b, a, c, l_ca * l_ab);
    return is_above_at(c, b, a, l_ab * l_bc);
  }
  /// cos^2 of the smallest angle: from 1/4 (equilateral) to 1 (flat).
  static double badness(Point a, Point b, Point c) {
    const Ratio r = squared_cos_of_smallest(a, b, c);
    return r.part / r.whole;
  }
  /// How far the worse of the two angles is from its bound, as squares of cosines; negative inside.
  double violation(Point a, Point b, Point c) const {
    const double small = badness(a, b, c) - squared_cos_;
    if (largest_ >= 180) return small;
    const double l_ab = squared_distance(a, b), l_bc = squared_distance(b, c),
                 l_ca = squared_distance(c, a);
    const double longest = std::max({l_ab, l_bc, l_ca});
    const double twice_dot = l_ab + l_bc + l_ca - 2 * longest;  // at the largest angle
    if (twice_dot >= 0) return small;
    const double large = 0.25 * squared(twice_dot) / (l_ab * l_bc * l_ca / longest);
    return std::max(small, large - squared_cos_of_largest_);
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

  bool is_above_at(Point a, Point apex, Point b, double squared_lengths) const {
    if (largest_ == 90) return is_obtuse(a, apex, b);
    const double d = dot(a - apex, b - apex);
    return d < 0 && squared(d) > squared_cos_of_largest_ * squared_lengths;
  }

  double squared_cos_;  // of the smallest angle allowed
  double largest_;      // in degrees
  double squared_cos_of_largest_;
};

}  // namespace lepp
