#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "lepp/geometry/point.hpp"

namespace lepp {

/// What lies inside an odd number of times, where the chain of corners closes itself.
/// Boxes around parts of the chain, in a tree, make questions about a place cost O(log corners)
/// where few sides are near it.
class PolygonArea {
 public:
  /// \pre  at least three corners
  PolygonArea(std::vector<Point> corners);

  const std::vector<Point>& corners() const { return corners_; }
  /// By the sides that a ray to the right crosses; exact for places on no side.
  bool contains(Point p) const;
  /// Of `p` from the nearest side, inside too. To rounding.
  double squared_distance_from_sides(Point p) const;
  /// True if `is_it(a, b)` is for a side ab. Not called for sides whose box lies apart from the one
  /// from `low` to `high`.
  template <class IsIt>
  bool any_side_near(Point low, Point high, IsIt is_it) const;

 private:
  struct Bounds {
    Point low, high;
  };
  // Part of the chain: sides begin to end - 1, from corner begin to corner end (of a closed chain).
  // Node 0 is all of it, nodes 2 i + 1 and 2 i + 2 are the halves of node i.
  struct Part {
    std::size_t node, begin, end;
  };
  static constexpr std::size_t sides_of_a_leaf = 4;
  static constexpr std::size_t deepest = 64;  // parts that wait at the same time: one per level

  Part whole() const { return {0, 0, leaves_ * sides_of_a_leaf}; }
  bool is_leaf(const Part& part) const { return part.node + 1 >= leaves_; }
  static std::array<Part, 2> halves(const Part& part) {
    const std::size_t middle = part.begin + (part.end - part.begin) / 2;
    return {Part{2 * part.node + 1, part.begin, middle}, Part{2 * part.node + 2, middle, part.end}};
  }
  std::size_t end_of(const Part& part) const { return std::min(part.end, corners_.size()); }
  Point corner(std::size_t i) const { return corners_[i < corners_.size() ? i : 0]; }
  double squared_distance_from_box(const Part& part, Point p) const;
  template <class Enter, class Side>
  void walk(Enter enter, Side side) const;

  std::vector<Point> corners_;
  std::size_t leaves_;         // a power of two; the last ones may have no sides
  std::vector<Bounds> boxes_;  // by node
};

// enter(part): whether to look into it; side(a, b): whether to go on. \pre at least three corners
template <class Enter, class Side>
void PolygonArea::walk(Enter enter, Side side) const {
  std::array<Part, deepest> pending;
  std::size_t count = 0;
  pending[count++] = whole();
  while (count > 0) {  // ends: each part is taken out once
    const Part part = pending[--count];
    if (part.begin >= corners_.size() || !enter(part)) continue;
    if (!is_leaf(part)) {
      const auto [first, second] = halves(part);
      pending[count++] = second;
      pending[count++] = first;
      continue;
    }
    for (std::size_t i = part.begin; i < end_of(part); ++i) {
      if (!side(corner(i), corner(i + 1))) return;
    }
  }
}

template <class IsIt>
bool PolygonArea::any_side_near(Point low, Point high, IsIt is_it) const {
  bool found = false;
  const auto is_near = [&](const Part& part) {
    const auto& [from, to] = boxes_[part.node];
    return from.x <= high.x && to.x >= low.x && from.y <= high.y && to.y >= low.y;
  };
  walk(is_near, [&](Point a, Point b) {
    found = is_it(a, b);
    return !found;
  });
  return found;
}

}  // namespace lepp
