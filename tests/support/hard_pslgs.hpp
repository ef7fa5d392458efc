#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "lepp/geometry/pslg.hpp"

namespace lepp::test {

/// A small random PSLG whose segments meet wherever they like: points on small grids, on rotated
/// grids, on pencils of lines and on few lines, moved by some ulp, far from the origin, and at any
/// scale of the supported range. Everything in it comes from `random`.
class HardPslg {
 public:
  explicit HardPslg(std::mt19937_64& random) : random_(random) {}

  Pslg make(std::size_t max_points, std::size_t max_segments) {
    kind_ = below(8);
    jitter_ = below(3) == 0 ? 0 : 1 + below(4);
    const double offsets[] = {0, 0, 0, 1e7, 1e15, 0x1p52};
    offset_ = offsets[below(6)];
    const int exponents[] = {0, 0, 0, -138, 140, static_cast<int>(below(270)) - 135};
    scale_ = std::ldexp(1.0, exponents[below(6)]);
    if (scale_ > 1) offset_ = offset_ > 1e8 ? 1e7 : offset_;
    if (scale_ < 0x1p-60) offset_ = 0;
    size_ = 2 + static_cast<int>(below(below(2) == 0 ? 4 : 15));
    Pslg pslg;
    const std::size_t points = 4 + below(max_points - 3), segments = 2 + below(max_segments - 1);
    for (std::size_t i = 0; i < points; ++i) pslg.points.push_back(point());
    const auto any = [&] { return VertexId(below(points)); };
    for (std::size_t i = 0; i < segments; ++i) pslg.segments.push_back({any(), any(), {}, 0, 1});
    return pslg;
  }

 private:
  std::uint64_t below(std::uint64_t n) { return random_() % n; }
  double whole() { return static_cast<double>(below(static_cast<std::uint64_t>(size_) + 1)); }

  Point shape() {
    Point p{whole(), whole()};
    switch (kind_) {
      case 1:  // a grid turned by the angle of 3-4-5
        return {0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y};
      case 2:  // a pencil through one point, and that point
        return {1.1 + p.x * std::cos(1.0 + p.y), 1.3 + p.x * std::sin(1.0 + p.y)};
      case 3:  // one line
        return {p.x / 3, 0.7 * p.x / 3};
      case 4:  // three parallel lines, next to each other up to rounding
        return {p.x / 7, p.x / 7 * 0.3 + 1e-16 * std::fmod(p.y, 3)};
      case 5:  // a thin strip
        return {p.x, p.y * 0x1p-50};
      case 6:  // many scales at once
        return {std::ldexp(p.x, -static_cast<int>(below(30))), std::ldexp(p.y, -10)};
      default:
        return p;
    }
  }

  double moved(double c) {
    const double up = std::numeric_limits<double>::infinity();
    for (std::uint64_t k = jitter_ == 0 ? 0 : below(jitter_); k > 0; --k) {
      c = std::nextafter(c, below(2) == 0 ? up : -up);
    }
    return supported(c);
  }

  static double supported(double c) { return std::abs(c) < min_coordinate ? 0 : c; }

  Point point() {
    const Point p = shape();
    return {moved(supported(scale_ * (p.x + offset_))), moved(supported(scale_ * (p.y + offset_)))};
  }

  std::mt19937_64& random_;
  std::uint64_t kind_ = 0, jitter_ = 0;
  double offset_ = 0, scale_ = 1;
  int size_ = 2;
};

inline Pslg hard_pslg(std::mt19937_64& random, std::size_t max_points = 29,
                      std::size_t max_segments = 17) {
  return HardPslg(random).make(max_points, max_segments);
}

}  // namespace lepp::test
