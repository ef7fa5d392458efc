#include "lepp/refine/feasible_place.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lepp {

namespace {

// Angles are asked for a trifle above the bound, so that rounding does not spoil a good place.
constexpr double surplus_deg = 1e-6;
constexpr int most_rounds = 8;

Point left_of(Point d) { return {-d.y, d.x}; }

}  // namespace

FeasiblePlace::FeasiblePlace(double min_angle_deg)
    : cos_(std::cos((min_angle_deg + surplus_deg) * std::numbers::pi / 180)),
      sin_(std::sin((min_angle_deg + surplus_deg) * std::numbers::pi / 180)) {}

std::optional<Point> FeasiblePlace::find(const Star& star, Point near) {
  edges_.clear();
  Point low, high;
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Point a = star.from(i) - near;
    edges_.push_back({a, star.to(i) - near, star.constrained[i] != 0});
    low = {std::min(low.x, a.x), std::min(low.y, a.y)};
    high = {std::max(high.x, a.x), std::max(high.y, a.y)};
  }
  polygon_.assign({low, {high.x, low.y}, high, {low.x, high.y}});
  for (const Edge& e : edges_) {
    if (!cut_by_lines(e)) return std::nullopt;
  }
  for (int round = 0; round < most_rounds; ++round) {
    const auto p = centroid();
    if (!p) return std::nullopt;
    bool good = true;
    for (const Edge& e : edges_) {
      if (!cut_by_circles(e, *p, good)) return std::nullopt;
    }
    if (good) return near + *p;
  }
  return std::nullopt;
}

bool FeasiblePlace::cut_by_lines(const Edge& e) {
  const Point d = e.b - e.a, n = left_of(d);
  const Point from_a = cos_ * n - sin_ * d, from_b = cos_ * n + sin_ * d;
  return cut(from_a, dot(from_a, e.a)) && cut(from_b, dot(from_b, e.b));
}

bool FeasiblePlace::cut_by_circles(const Edge& e, Point p, bool& good) {
  const Point d = e.b - e.a, n = left_of(d), middle = midpoint(e.a, e.b);
  const double quarter = 0.25 * dot(d, d);
  const Point center = middle + (0.5 * cos_ / sin_) * n;
  const double squared_radius = quarter / (sin_ * sin_);
  const double off = squared_distance(center, p);
  if (off > squared_radius) {
    good = false;
    const Point normal = (1 / std::sqrt(off)) * (center - p);
    if (!cut(normal, dot(normal, center) - std::sqrt(squared_radius))) return false;
  }
  if (e.constrained && squared_distance(middle, p) < quarter) {
    good = false;
    const Point away = dot(p - middle, n) > 0 ? p - middle : n;
    const Point normal = (1 / std::sqrt(dot(away, away))) * away;
    if (!cut(normal, dot(normal, middle) + std::sqrt(quarter))) return false;
  }
  return true;
}

bool FeasiblePlace::cut(Point normal, double least) {
  sides_.clear();
  bool any_in = false, any_out = false;
  for (const Point p : polygon_) {
    const double side = dot(normal, p) - least;
    sides_.push_back(side);
    (side >= 0 ? any_in : any_out) = true;
  }
  if (!any_in) return false;
  if (!any_out) return true;
  next_.clear();
  for (std::size_t i = 0; i < polygon_.size(); ++i) {
    const std::size_t j = i + 1 == polygon_.size() ? 0 : i + 1;
    const double here = sides_[i], there = sides_[j];
    if (here >= 0) next_.push_back(polygon_[i]);
    if ((here >= 0) != (there >= 0)) {
      next_.push_back(polygon_[i] + here / (here - there) * (polygon_[j] - polygon_[i]));
    }
  }
  polygon_.swap(next_);
  return true;
}

std::optional<Point> FeasiblePlace::centroid() const {
  const Point o = polygon_.front();
  Point sum;
  double area = 0;
  for (std::size_t i = 1; i + 1 < polygon_.size(); ++i) {
    const Point u = polygon_[i] - o, w = polygon_[i + 1] - o;
    const double part = cross(u, w);
    area += part;
    sum = sum + part * (u + w);
  }
  if (!(area > 0)) return std::nullopt;
  return o + (1 / (3 * area)) * sum;
}

}  // namespace lepp
