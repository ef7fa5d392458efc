#include "lepp/bisection/polygon_area.hpp"

#include <bit>
#include <limits>
#include <utility>

#include "lepp/geometry/place_on_segment.hpp"
#include "lepp/geometry/predicates.hpp"

namespace lepp {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

PolygonArea::PolygonArea(std::vector<Point> corners)
    : corners_(std::move(corners)),
      leaves_(std::bit_ceil((corners_.size() + sides_of_a_leaf - 1) / sides_of_a_leaf)),
      boxes_(2 * leaves_ - 1, Bounds{{infinite, infinite}, {-infinite, -infinite}}) {
  for (std::size_t node = boxes_.size(); node-- > 0;) {
    auto& [low, high] = boxes_[node];
    const auto add = [&](Point from, Point to) {
      low = {std::min(low.x, from.x), std::min(low.y, from.y)};
      high = {std::max(high.x, to.x), std::max(high.y, to.y)};
    };
    if (node + 1 >= leaves_) {
      const std::size_t begin = (node + 1 - leaves_) * sides_of_a_leaf;
      const std::size_t end = std::min(begin + sides_of_a_leaf, corners_.size());
      for (std::size_t i = begin; i < end; ++i) {
        add(corner(i), corner(i));
        add(corner(i + 1), corner(i + 1));
      }
    } else {
      for (const std::size_t half : {2 * node + 1, 2 * node + 2}) {
        add(boxes_[half].low, boxes_[half].high);
      }
    }
  }
}

// A part of the chain to the right of `p` is crossed an odd number of times if and only if its two
// ends lie on different sides of the ray, whatever it does between them.
bool PolygonArea::contains(Point p) const {
  bool inside = false;
  const auto crosses = [&](Point a, Point b) { return (a.y > p.y) != (b.y > p.y); };
  const auto enter = [&](const Part& part) {
    const auto& [low, high] = boxes_[part.node];
    if (high.x < p.x || low.y > p.y || high.y <= p.y) return false;
    if (low.x <= p.x) return true;
    inside ^= crosses(corner(part.begin), corner(end_of(part)));
    return false;
  };
  walk(enter, [&](Point a, Point b) {
    if (crosses(a, b)) inside ^= (a.y < b.y ? orient2d(a, b, p) : orient2d(b, a, p)) > 0;
    return true;
  });
  return inside;
}

double PolygonArea::squared_distance_from_box(const Part& part, Point p) const {
  const auto& [low, high] = boxes_[part.node];
  const double dx = std::max({low.x - p.x, p.x - high.x, 0.0});
  const double dy = std::max({low.y - p.y, p.y - high.y, 0.0});
  return dx * dx + dy * dy;
}

// The nearer half first, so that most others are too far away.
double PolygonArea::squared_distance_from_sides(Point p) const {
  double least = infinite;
  std::array<Part, deepest> pending;
  std::size_t count = 0;
  pending[count++] = whole();
  while (count > 0) {  // ends: each part is taken out once
    const Part part = pending[--count];
    if (part.begin >= corners_.size() || squared_distance_from_box(part, p) >= least) continue;
    if (is_leaf(part)) {
      for (std::size_t i = part.begin; i < end_of(part); ++i) {
        least = std::min(least, nearest_place(corner(i), corner(i + 1), p).squared_distance);
      }
      continue;
    }
    auto [first, second] = halves(part);
    if (squared_distance_from_box(second, p) < squared_distance_from_box(first, p)) {
      std::swap(first, second);
    }
    pending[count++] = second;
    pending[count++] = first;
  }
  return least;
}

}  // namespace lepp
