#include "lepp/refine/feasible_place.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace lepp {

namespace {

// Angles are asked for a trifle above the bound, so that rounding does not spoil a good place.
constexpr double surplus_deg = 1e-6;
constexpr int most_rounds = 8;

Point left_of(Point d) { return {-d.y, d.x}; }

}  // namespace

FeasiblePlace::FeasiblePlace(double min_angle_deg, double max_angle_deg)
    : cos_(std::cos((min_angle_deg + surplus_deg) * std::numbers::pi / 180)),
      sin_(std::sin((min_angle_deg + surplus_deg) * std::numbers::pi / 180)),
      squared_cos_of_twice_(std::pow(cos_ * cos_ - sin_ * sin_, 2)),
      has_largest_(max_angle_deg < 180),
      no_obtuse_(max_angle_deg <= 90),
      cos_largest_(std::cos((max_angle_deg - surplus_deg) * std::numbers::pi / 180)),
      sin_largest_(std::sin((max_angle_deg - surplus_deg) * std::numbers::pi / 180)),
      most_edges_(static_cast<std::size_t>(std::min(360 / (min_angle_deg + surplus_deg), 40.0))) {}

std::optional<Point> FeasiblePlace::find(const Star& star, Point near) {
  if (!set_edges(star, near)) return std::nullopt;
  // All places lie in the disc of the shortest edge.
  const Edge& shortest = edges_.front();
  const Point center =
      midpoint(shortest.a, shortest.b) + (0.5 * cos_ / sin_) * left_of(shortest.b - shortest.a);
  const double r = 0.5 * std::sqrt(shortest.squared_length) / sin_;
  if (any_edge_out_of_reach(center, r)) return std::nullopt;
  polygon_[0] = center + Point{-r, -r};
  polygon_[1] = center + Point{r, -r};
  polygon_[2] = center + Point{r, r};
  polygon_[3] = center + Point{-r, r};
  corners_ = 4;
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

// The shortest edge first, which leaves least, then the longest, which is likely to forbid that.
bool FeasiblePlace::set_edges(const Star& star, Point near) {
  if (star.size() > most_edges_) return false;  // each takes its share of 360 degrees
  edges_.clear();
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Point a = star.from(i) - near, b = star.to(i) - near;
    edges_.push_back({a, b, squared_distance(a, b), star.link[i].constrained});
    if (i > 0 && is_corner_impossible(edges_[i - 1], edges_[i])) return false;
  }
  if (is_corner_impossible(edges_.back(), edges_.front())) return false;
  const auto by_length = [](const Edge& e, const Edge& f) {
    return e.squared_length < f.squared_length;
  };
  std::iter_swap(edges_.begin(), std::ranges::min_element(edges_, by_length));
  std::iter_swap(edges_.begin() + 1, std::max_element(edges_.begin() + 1, edges_.end(), by_length));
  return true;
}

//       a          two triangles share the corner at b, so that it must have twice the bound,
//                  and, where no angle may be obtuse, at most 180 degrees;
//      /           e is ab, f is bc, the center lies on their left
//     b ---- c
bool FeasiblePlace::is_corner_impossible(const Edge& e, const Edge& f) const {
  const Point to_a = e.a - e.b, to_c = f.b - f.a;
  const double d = dot(to_a, to_c);
  if (no_obtuse_ && cross(to_c, to_a) < 0) return true;
  return d > 0 && d * d > squared_cos_of_twice_ * (e.squared_length * f.squared_length) &&
         cross(to_c, to_a) > 0;
}

// All places lie in the disc of the shortest edge: the half-planes and the disc of each other edge
// must meet it.
bool FeasiblePlace::any_edge_out_of_reach(Point center, double r) const {
  return std::any_of(edges_.begin() + 1, edges_.end(), [&](const Edge& e) {
    const Point d = e.b - e.a, n = left_of(d), to_a = center - e.a;
    const double along = dot(d, to_a), beside = cos_ * dot(n, to_a);
    const double length = std::sqrt(e.squared_length), reach = -r * length;
    if (beside - sin_ * along < reach) return true;
    if (beside + sin_ * (along - e.squared_length) < reach) return true;
    const double between = squared_distance(center, midpoint(e.a, e.b) + (0.5 * cos_ / sin_) * n);
    const double both = r + 0.5 * length / sin_;
    return between > both * both;
  });
}

bool FeasiblePlace::cut_by_lines(const Edge& e) {
  const Point d = e.b - e.a, n = left_of(d);
  const Point from_a = cos_ * n - sin_ * d, from_b = cos_ * n + sin_ * d;
  if (!cut(from_a, dot(from_a, e.a)) || !cut(from_b, dot(from_b, e.b))) return false;
  if (!has_largest_) return true;
  const Point up_to_a = sin_largest_ * d - cos_largest_ * n,
              up_to_b = -sin_largest_ * d - cos_largest_ * n;
  return cut(up_to_a, dot(up_to_a, e.a)) && cut(up_to_b, dot(up_to_b, e.b));
}

bool FeasiblePlace::cut_by_circles(const Edge& e, Point p, bool& good) {
  const Point d = e.b - e.a, n = left_of(d), middle = midpoint(e.a, e.b);
  const double quarter = 0.25 * e.squared_length;
  const Point center = middle + (0.5 * cos_ / sin_) * n;
  const double squared_radius = quarter / (sin_ * sin_);
  const double off = squared_distance(center, p);
  if (off > squared_radius) {
    good = false;
    const Point normal = (1 / std::sqrt(off)) * (center - p);
    if (!cut(normal, dot(normal, center) - std::sqrt(squared_radius))) return false;
  }
  if (e.constrained) return keep_out(middle, quarter, n, p, good);
  if (!has_largest_) return true;
  return keep_out(middle + (0.5 * cos_largest_ / sin_largest_) * n,
                  quarter / (sin_largest_ * sin_largest_), n, p, good);
}

// Where p is inside a circle, whatever lies behind the tangent nearest to it goes.
bool FeasiblePlace::keep_out(Point center, double squared_radius, Point n, Point p, bool& good) {
  if (squared_distance(center, p) >= squared_radius) return true;
  good = false;
  const Point away = dot(p - center, n) > 0 ? p - center : n;
  const Point normal = (1 / std::sqrt(dot(away, away))) * away;
  return cut(normal, dot(normal, center) + std::sqrt(squared_radius));
}

bool FeasiblePlace::cut(Point normal, double least) {
  std::array<double, most_corners> side;
  std::size_t inside = 0;
  for (std::size_t i = 0; i < corners_; ++i) {
    side[i] = dot(normal, polygon_[i]) - least;
    inside += side[i] >= 0 ? 1 : 0;
  }
  if (inside == corners_) return true;
  if (inside == 0 || corners_ + 2 > most_corners) return false;
  std::size_t n = 0;
  for (std::size_t i = 0; i < corners_; ++i) {
    const std::size_t j = i + 1 == corners_ ? 0 : i + 1;
    if (side[i] >= 0) next_[n++] = polygon_[i];
    if ((side[i] >= 0) != (side[j] >= 0)) {
      next_[n++] = polygon_[i] + side[i] / (side[i] - side[j]) * (polygon_[j] - polygon_[i]);
    }
  }
  std::swap(polygon_, next_);
  corners_ = n;
  return true;
}

std::optional<Point> FeasiblePlace::centroid() const {
  const Point o = polygon_[0];
  Point sum;
  double area = 0;
  for (std::size_t i = 1; i + 1 < corners_; ++i) {
    const Point u = polygon_[i] - o, w = polygon_[i + 1] - o;
    const double part = cross(u, w);
    area += part;
    sum = sum + part * (u + w);
  }
  if (!(area > 0)) return std::nullopt;
  return o + (1 / (3 * area)) * sum;
}

}  // namespace lepp
