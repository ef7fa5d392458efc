#pragma once

#include <array>
#include <cstdint>

#include "lepp/geometry/point.hpp"

namespace lepp {

/// What two triangles have in common: a convex polygon with at most six corners, counter-clockwise.
class CommonPart {
 public:
  /// `triangle`, less what is beyond the edges of `other`; both counter-clockwise. Coordinates are
  /// relative to the first corner of `triangle`. Parts thinner than rounding may be there or not.
  CommonPart(const std::array<Point, 3>& triangle, const std::array<Point, 3>& other);

  std::uint32_t size() const { return count_; }
  Point corner(std::uint32_t i) const { return corners_[i].at; }
  double area() const;
  /// Whether a side lies on edge i of `other` (opposite its corner i) and `triangle` goes on beyond
  /// it.
  bool goes_on_across(std::uint32_t i) const;

 private:
  static constexpr std::uint32_t own = 3;
  struct Corner {
    Point at;
    std::uint32_t side;  // from here to the next corner: the edge of `other` it was cut by, or own
  };
  void cut(Point a, Point b, std::uint32_t edge);

  std::array<Corner, 8> corners_;
  std::uint32_t count_ = 3;
};

}  // namespace lepp
