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
  /// cos^2 of an angle, kept as a ratio: comparing takes no division.
  struct SquaredCos {
    double part, whole;
    bool operator>(double limit) const { return part > limit * whole; }
  };

  /// Bounds of 0 and 180 ask for nothing. \pre max_angle_deg >= 90
  explicit AngleTest(double min_angle_deg, double max_angle_deg = 180)
      : squared_cos_(min_angle_deg > 0 ? squared_cos(min_angle_deg - forgiven_deg) : 2),
        largest_(max_angle_deg),
        cos_largest_(std::cos(radians(max_angle_deg + forgiven_deg))),
        sin_largest_(std::sin(radians(max_angle_deg + forgiven_deg))) {}

  bool is_bad(Point a, Point b, Point c) const { return is_below(a, b, c) || is_above(a, b, c); }

  bool is_below(Point a, Point b, Point c) const { return of_smallest(a, b, c) > squared_cos_; }
  /// The same from the squared lengths of the sides.
  bool is_below(double l_ab, double l_bc, double l_ca) const {
    return of_smallest(l_ab, l_bc, l_ca) > squared_cos_;
  }
  bool is_below(SquaredCos smallest) const { return smallest > squared_cos_; }
  /// False if no triangle is_above() the bound.
  bool has_largest() const { return largest_ < 180; }
  /// Exact where the bound is 90 degrees. All three corners are asked: which side of a needle is
  /// the longest is lost in rounding.
  bool is_above(Point a, Point b, Point c) const {
    return largest_ < 180 && (is_above_at(a, b, c) || is_above_at(b, c, a) || is_above_at(c, a, b));
  }
  /// cos^2 of the smallest angle: from 1/4 (equilateral) to 1 (flat).
  static double badness(Point a, Point b, Point c) {
    const SquaredCos r = of_smallest(a, b, c);
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
    return std::max(small, large - squared(cos_largest_));
  }
  static double squared_cos(double angle_deg) { return squared(std::cos(radians(angle_deg))); }

  /// The smallest angle faces the shortest side, so that nothing cancels in the law of cosines. No
  /// branches: which side is shortest cannot be predicted.
  static SquaredCos of_smallest(double l_ab, double l_bc, double l_ca) {
    const double low = std::min(l_ab, l_bc), p = std::max(l_ab, l_bc);
    const double shortest = std::min(low, l_ca), q = std::max(low, l_ca);
    return {0.25 * squared(p + q - shortest), p * q};
  }
  static SquaredCos of_smallest(Point a, Point b, Point c) {
    return of_smallest(squared_distance(a, b), squared_distance(b, c), squared_distance(c, a));
  }

 private:
  // Half of what the report forgives, so that rounding never parts the two.
  static constexpr double forgiven_deg = 5e-10;
  static double squared(double x) { return x * x; }
  static double radians(double deg) { return deg * std::numbers::pi / 180; }

  // The sine of the difference between the angle and its bound, both above 90 degrees.
  bool is_above_at(Point a, Point apex, Point b) const {
    if (largest_ == 90) return is_obtuse(a, apex, b);
    const Point u = a - apex, w = b - apex;
    const double d = dot(u, w);
    return d < 0 && cos_largest_ * std::abs(cross(u, w)) > sin_largest_ * d;
  }

  double squared_cos_;  // of the smallest angle allowed
  double largest_;      // in degrees
  double cos_largest_, sin_largest_;
};

}  // namespace lepp
