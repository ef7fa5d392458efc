#pragma once

#include <array>

#include "lepp/geometry/point.hpp"

namespace lepp {

/// The function that is linear on a triangle, with these values at its corners.
/// \pre  the computed area is not 0
class LinearFunction {
 public:
  LinearFunction(const std::array<Point, 3>& x, const std::array<double, 3>& values)
      : at_(x[0]), value_(values[0]) {
    const Point a = x[1] - x[0], b = x[2] - x[0];
    const double to_a = values[1] - values[0], to_b = values[2] - values[0];
    const double scale = 1 / cross(a, b);
    gradient_ = {scale * (to_a * b.y - to_b * a.y), scale * (to_b * a.x - to_a * b.x)};
  }

  double operator()(Point p) const { return value_ + dot(gradient_, p - at_); }
  Point gradient() const { return gradient_; }

 private:
  Point at_, gradient_;
  double value_;
};

}  // namespace lepp
