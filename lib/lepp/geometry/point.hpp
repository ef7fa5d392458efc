#pragma once

#include <compare>

namespace lepp {

/// A place in the plane, in the length unit of the input. Nothing but coordinates: a vertex of a
/// mesh is a VertexId.
struct Point {
  double x = 0;
  double y = 0;
  friend bool operator==(const Point&, const Point&) = default;
  /// Lexicographic, x first; the order that breaks ties between edges of equal length.
  friend auto operator<=>(const Point&, const Point&) = default;
};

inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
inline double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
inline double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }

/// |a - b|^2, the same double for (a, b) and (b, a).
inline double squared_distance(Point a, Point b) {
  const Point d = b - a;
  return d.x * d.x + d.y * d.y;
}

/// The halfway point, the same for (a, b) and (b, a). Halving first would lose a bit near zero;
/// the supported coordinate range (pslg.hpp) keeps the sum finite.
inline Point midpoint(Point a, Point b) { return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}; }

}  // namespace lepp
