#pragma once

#include <array>
#include <optional>
#include <vector>

#include "lepp/geometry/point.hpp"
#include "lepp/triangulation/relocate.hpp"

namespace lepp {

/// Where the center of a star can go so that every angle of the star reaches a bound. Each edge ab
/// of its link, seen counter-clockwise, asks for three things of the center p:
///
///           ______              the angles at a and b reach the bound: p lies left of a line
///         /  p     \            through a, and of one through b (two half-planes);
///        |  / \     |           the angle at p does: p lies in a disc through a and b.
///         \/   \   /            A constrained ab asks for more: p outside its diametral circle.
///     ----a-----b----
///
/// A bound on the largest angle asks the same from the other sides: two more half-planes, which at
/// 90 degrees are a strip, and p outside a circle through a and b. But for such circles, this is
/// convex. A polygon is cut down by the half-planes, then by tangents of
/// the circles that its centroid violates, until the centroid is good or nothing is left.
class FeasiblePlace {
 public:
  explicit FeasiblePlace(double min_angle_deg, double max_angle_deg = 180);
  FeasiblePlace(const FeasiblePlace&) = delete;  // refers to its own buffers
  FeasiblePlace& operator=(const FeasiblePlace&) = delete;

  /// \param near  a point near the star, or in it: differences from it are what is rounded
  /// \return a place well inside the feasible region, or nothing if there is none (or it is tiny)
  std::optional<Point> find(const Star& star, Point near);

 private:
  struct Edge {
    Point a, b;
    double squared_length;
    bool constrained;
  };
  static constexpr std::size_t most_corners = 96;

  /// Puts the edges in the order that finds out soonest when nothing is left.
  bool set_edges(const Star& star, Point near);
  bool is_corner_impossible(const Edge& e, const Edge& f) const;
  bool any_edge_out_of_reach(Point center, double r) const;
  // Keeps the points with dot(normal, p) >= least; false if none is left.
  bool cut(Point normal, double least);
  bool cut_by_lines(const Edge& e);
  // Cuts off `p` where a circle forbids it. False if nothing is left.
  bool cut_by_circles(const Edge& e, Point p, bool& good);
  bool keep_out(Point center, double squared_radius, Point n, Point p, bool& good);
  std::optional<Point> centroid() const;

  double cos_, sin_;
  double squared_cos_of_twice_;
  bool has_largest_, no_obtuse_;
  double cos_largest_, sin_largest_;
  std::size_t most_edges_;
  std::vector<Edge> edges_;
  std::size_t corners_ = 0;  // of the polygon
  std::array<std::array<Point, most_corners>, 2> buffers_;
  Point* polygon_ = buffers_[0].data();
  Point* next_ = buffers_[1].data();  // where the next cut writes
};

}  // namespace lepp
