#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "lepp/geometry/point.hpp"

namespace lepp {

/// From coordinates of a mesh to those of a drawing: the corner is subtracted first, y points down,
/// and a margin is left on all sides.
class PictureFrame {
 public:
  /// \param longest_side  of the drawing without its margins
  PictureFrame(std::span<const Point> points, double longest_side, double margin)
      : margin_(margin) {
    for (const Point p : points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
    scale_ = longest_side / std::max(high_.x - low_.x, high_.y - low_.y);
  }

  double width() const { return 2 * margin_ + scale_ * (high_.x - low_.x); }
  double height() const { return 2 * margin_ + scale_ * (high_.y - low_.y); }
  double scale() const { return scale_; }
  Point place(Point p) const {
    return {margin_ + scale_ * (p.x - low_.x), margin_ + scale_ * (high_.y - p.y)};
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Point low_{infinity, infinity}, high_{-infinity, -infinity};
  double margin_, scale_ = 1;
};

}  // namespace lepp
