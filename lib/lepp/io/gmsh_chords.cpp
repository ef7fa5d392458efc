#include "lepp/io/gmsh_chords.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace lepp {
namespace {

constexpr int most_rounds = 12;
constexpr double same_direction = 1e-9;  // radians; rounding of a direction, not of a design

/// Control polygon of the part of a cubic between s_a and s_b, by cutting it twice.
std::array<Point, 4> part_of(const std::array<Point, 4>& cubic, double s_a, double s_b) {
  const auto blossom = [&](double r, double s, double t) {
    std::array<Point, 4> p = cubic;
    std::size_t n = 3;
    for (const double u : {r, s, t}) {
      for (std::size_t i = 0; i < n; ++i) p[i] = (1 - u) * p[i] + u * p[i + 1];
      --n;
    }
    return p[0];
  };
  return {blossom(s_a, s_a, s_a), blossom(s_a, s_a, s_b), blossom(s_a, s_b, s_b),
          blossom(s_b, s_b, s_b)};
}

// One overload per kind of curve: points whose convex hull, with the chord's ends, holds the piece.
void add_hull(const StraightCurve&, double, double, std::vector<Point>&) {}

void add_hull(const EllipseArc& arc, double t_a, double t_b, std::vector<Point>& points) {
  const double turn = (t_b - t_a) * arc.sweep;
  const double n = std::max(1.0, std::ceil(std::abs(turn) / (std::numbers::pi / 6)));
  const double half = turn / n / 2;
  for (double i = 0; i < n; ++i) {  // where the tangents of neighbouring parts meet
    const double angle = arc.start + t_a * arc.sweep + (2 * i + 1) * half;
    points.push_back(arc.center +
                     1 / std::cos(half) * (std::cos(angle) * arc.u + std::sin(angle) * arc.v));
  }
}

void add_hull(const CubicPieces& cubics, double t_a, double t_b, std::vector<Point>& points) {
  for (std::size_t i = 0; i < cubics.pieces.size(); ++i) {
    const double low = cubics.knots[i], high = cubics.knots[i + 1], width = high - low;
    if (high <= t_a || low >= t_b) continue;
    const double s_a = std::max(0.0, (t_a - low) / width), s_b = std::min(1.0, (t_b - low) / width);
    for (const Point p : part_of(cubics.pieces[i], s_a, s_b)) points.push_back(p);
  }
}

/// Counter-clockwise convex hull, by the monotone chain.
std::vector<Point> convex_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Point> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t start = hull.size();
    for (const Point p : points) {
      while (hull.size() >= start + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

struct Item {
  std::optional<ChordPlace> place;  // none: an isolated point
  bool curved = false;
  Point a, b;
  std::vector<Point> hull;
  Point low, high;
};

Item item_of(std::optional<ChordPlace> place, bool curved, Point a, Point b,
             std::vector<Point> points) {
  points.push_back(a);
  points.push_back(b);
  Item item{place, curved, a, b, convex_hull(std::move(points)), a, a};
  for (const Point p : item.hull) {
    item.low = {std::min(item.low.x, p.x), std::min(item.low.y, p.y)};
    item.high = {std::max(item.high.x, p.x), std::max(item.high.y, p.y)};
  }
  return item;
}

std::vector<Item> all_items(const std::vector<Polyline>& polylines,
                            std::span<const Point> isolated) {
  std::vector<Item> items;
  for (std::size_t i = 0; i < polylines.size(); ++i) {
    const auto& geometry = polylines[i].geometry;
    const auto& points = polylines[i].points;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      std::vector<Point> hull;
      std::visit([&](const auto& shape) { add_hull(shape, points[k].t, points[k + 1].t, hull); },
                 geometry);
      items.push_back(item_of(ChordPlace{i, k}, !is_straight(geometry), points[k].point,
                              points[k + 1].point, std::move(hull)));
    }
  }
  for (const Point p : isolated) items.push_back(item_of(std::nullopt, false, p, p, {}));
  return items;
}

/// True if a line across `axis` lies strictly between the two hulls.
bool separates(Point axis, const Item& s, const Item& t) {
  const auto range = [axis](const Item& item) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Point p : item.hull) {
      low = std::min(low, dot(axis, p));
      high = std::max(high, dot(axis, p));
    }
    return std::pair{low, high};
  };
  const auto [s_low, s_high] = range(s);
  const auto [t_low, t_high] = range(t);
  return s_high < t_low || t_high < s_low;
}

/// Two convex sets are apart iff a normal of one of their edges separates them.
bool apart(const Item& s, const Item& t) {
  for (const Item* item : {&s, &t}) {
    const auto& hull = item->hull;
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Point edge = hull[(i + 1) % hull.size()] - hull[i];
      if (separates({-edge.y, edge.x}, s, t)) return true;
      if (hull.size() == 2 && separates(edge, s, t)) return true;  // along a degenerate hull
    }
  }
  return separates({1, 0}, s, t) || separates({0, 1}, s, t);
}

struct Wedge {
  double middle = 0, low = 0, high = 0;  // directions, low and high relative to the middle
};

Wedge wedge_at(Point apex, const Item& item) {
  Point sum;
  for (const Point p : item.hull) {
    const Point d = p - apex;
    const double norm = std::hypot(d.x, d.y);
    if (norm > 0) sum = sum + 1 / norm * d;
  }
  Wedge wedge{std::atan2(sum.y, sum.x), 0, 0};
  for (const Point p : item.hull) {
    const Point d = p - apex;
    if (d == Point{}) continue;
    const double angle = std::atan2(cross(sum, d), dot(sum, d));
    wedge.low = std::min(wedge.low, angle);
    wedge.high = std::max(wedge.high, angle);
  }
  return wedge;
}

/// Whether two hulls that share the point `apex` leave it in directions that overlap.
bool overlap_at(Point apex, const Item& s, const Item& t) {
  const Wedge a = wedge_at(apex, s), b = wedge_at(apex, t);
  const double between = std::remainder(b.middle - a.middle, 2 * std::numbers::pi);
  for (const double turn : {-2 * std::numbers::pi, 0.0, 2 * std::numbers::pi}) {
    const double gap = std::max(between + turn + b.low - a.high, a.low - b.high - between - turn);
    if (gap < -same_direction) return true;
  }
  return false;
}

bool collide(const Item& s, const Item& t) {
  const bool a_shared = s.a == t.a || s.a == t.b, b_shared = s.b == t.a || s.b == t.b;
  if (s.a == s.b || t.a == t.b) return !apart(s, t);  // an isolated point, or a loop in one piece
  if (a_shared && b_shared) return true;              // one chord for two pieces
  if (a_shared) return overlap_at(s.a, s, t);
  if (b_shared) return overlap_at(s.b, s, t);
  return !apart(s, t);
}

/// For each curved piece whether it must be halved. Of two, the longer goes first.
std::vector<bool> colliding(std::vector<Item>& items) {
  std::sort(items.begin(), items.end(),
            [](const Item& s, const Item& t) { return s.low.x < t.low.x; });
  std::vector<bool> result(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Item& s = items[i];
    if (s.curved && s.a == s.b) result[i] = true;
    for (std::size_t j = i + 1; j < items.size() && items[j].low.x <= s.high.x; ++j) {
      const Item& t = items[j];
      if (!s.curved && !t.curved) continue;
      if (t.low.y > s.high.y || s.low.y > t.high.y || !collide(s, t)) continue;
      const double s_length = squared_distance(s.a, s.b), t_length = squared_distance(t.a, t.b);
      if (s.curved && (!t.curved || 2 * s_length > t_length)) result[i] = true;
      if (t.curved && (!s.curved || 2 * t_length > s_length)) result[j] = true;
    }
  }
  return result;
}

std::vector<ChordPlace> collisions(const std::vector<Polyline>& polylines,
                                   std::span<const Point> isolated) {
  std::vector<Item> items = all_items(polylines, isolated);
  const std::vector<bool> bad = colliding(items);
  std::vector<ChordPlace> places;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (bad[i]) places.push_back(*items[i].place);
  std::sort(places.begin(), places.end(), [](const ChordPlace& a, const ChordPlace& b) {
    return std::pair(a.polyline, a.piece) < std::pair(b.polyline, b.piece);
  });
  return places;
}

CurvePoint middle(const Polyline& line, std::size_t piece) {
  const CurvePoint &a = line.points[piece], &b = line.points[piece + 1];
  if (a.point == b.point) {  // a closed curve in one piece has no point equally far from its ends
    const double t = 0.5 * (a.t + b.t);
    return {point_at(line.geometry, t), t};
  }
  return halfway(line.geometry, {a.point, b.point, a.t, b.t});
}

}  // namespace

std::vector<ChordPlace> separate_chords(std::vector<Polyline>& polylines,
                                        std::span<const Point> isolated) {
  std::vector<ChordPlace> places = collisions(polylines, isolated);
  for (int round = 0; round < most_rounds && !places.empty(); ++round) {
    // From the back, so that indices of earlier pieces stay right.
    for (auto place = places.rbegin(); place != places.rend(); ++place) {
      Polyline& line = polylines[place->polyline];
      const auto at = line.points.begin() + static_cast<std::ptrdiff_t>(place->piece) + 1;
      line.points.insert(at, middle(line, place->piece));
    }
    places = collisions(polylines, isolated);
  }
  return places;
}

}  // namespace lepp
