#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "lepp/geometry/point.hpp"

namespace lepp {

/// What a side of a CutPolygon lies on.
struct Side {
  enum class Kind : std::uint32_t {
    edge,      ///< edge `index` of the triangle it was cut from
    ray,       ///< a ray from the origin
    bisector,  ///< the bisector of the origin and neighbour `index`
  };
  Kind kind = Kind::edge;
  std::uint32_t index = 0;
  friend bool operator==(Side, Side) = default;
};

/// The half-plane normal . q <= limit.
struct HalfPlane {
  Point normal;
  double limit = 0;
};

/// The points nearer to the origin than to `d`.
inline HalfPlane nearer_to_origin_than(Point d) { return {d, 0.5 * dot(d, d)}; }
/// The points on the left of the ray from the origin through `d`, and those on its right.
inline HalfPlane left_of_ray(Point d) { return {{d.y, -d.x}, 0}; }
inline HalfPlane right_of_ray(Point d) { return {{-d.y, d.x}, 0}; }

/// A convex counter-clockwise polygon whose sides remember what they lie on.
class CutPolygon {
 public:
  struct Corner {
    Point at;
    Side side;  ///< from here to the next corner
  };

  std::span<const Corner> corners() const { return {corners_.data(), count_}; }
  const Corner& after(std::size_t i) const { return corners_[i + 1 == count_ ? 0 : i + 1]; }

  /// Corners first, first + 1 and first + 2 (mod 3) of a triangle; edge i is opposite corner i, as
  /// in a Mesh.
  void start_with(Point a, Point b, Point c, std::uint32_t first = 0);

  /// The part of the triangle (origin, a, b), whose corners have the numbers first, first + 1 and
  /// first + 2, that is nearer to the origin than to a and b, which are neighbours 0 and 1.
  /// \return  false, and nothing is done, unless all angles are plainly below 90 degrees: then the
  ///          bisectors meet inside, and the part is that of start_with() and two cuts
  [[nodiscard]] bool start_with_acute(Point a, Point b, std::uint32_t first);

  /// Keeps the part inside `half_plane`; the new side is labelled `side`.
  /// A corner that is on its line up to rounding counts as on it, so no part thinner than rounding
  /// comes off or is left over.
  /// \return  false if nothing would be left; the polygon is then as it was
  [[nodiscard]] bool keep(const HalfPlane& half_plane, Side side);

  /// Area, with differences taken from the first corner.
  double area() const;

 private:
  static Side edge(std::uint32_t i) { return {Side::Kind::edge, i > 2 ? i - 3 : i}; }
  void cut_along_line(Side side);

  // Room for more corners than there are: a cut then writes without asking.
  std::size_t count_ = 0;
  std::vector<Corner> corners_ = std::vector<Corner>(4);
  std::vector<Corner> kept_;  // scratch
  std::vector<double> beyond_ =
      std::vector<double>(4);  // per corner: > 0 outside the half-plane, < 0 inside
};

// Inline: most cuts take nothing off, and to find that out is all they do.

inline void CutPolygon::start_with(Point a, Point b, Point c, std::uint32_t first) {
  count_ = 3;
  corners_[0] = {a, edge(first + 2)};
  corners_[1] = {b, edge(first)};
  corners_[2] = {c, edge(first + 1)};
}

//      b            The bisectors of a and b meet in c: the part is origin, a/2, c, b/2.
//      | `.
//    b/2---c `.
//      |    |  `.
//   origin-a/2---a
inline bool CutPolygon::start_with_acute(Point a, Point b, std::uint32_t first) {
  const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b);
  const double plainly = 1e-6 * (aa + bb);
  if (!(ab > plainly && aa - ab > plainly && bb - ab > plainly)) return false;
  const double scale = 0.5 / cross(a, b);
  count_ = 4;
  corners_[0] = {{0, 0}, edge(first + 2)};
  corners_[1] = {0.5 * a, {Side::Kind::bisector, 0}};
  corners_[2] = {{scale * (aa * b.y - bb * a.y), scale * (bb * a.x - aa * b.x)},
                 {Side::Kind::bisector, 1}};
  corners_[3] = {0.5 * b, edge(first + 1)};
  return true;
}

namespace rounding {
// How far from zero, relative to the size of its terms, normal . q - limit must be to be told from
// it: some tens of roundings of the coordinates and of the products.
inline constexpr double on_line = 1e-14;
inline double sum_of_sizes(Point p) { return std::abs(p.x) + std::abs(p.y); }
}  // namespace rounding

inline bool CutPolygon::keep(const HalfPlane& half_plane, Side side) {
  const double reach = rounding::on_line * rounding::sum_of_sizes(half_plane.normal);
  bool any_inside = false, any_beyond = false;
  for (std::size_t i = 0; i < count_; ++i) {
    const Point q = corners_[i].at;
    const double beyond = dot(half_plane.normal, q) - half_plane.limit;
    const double rounding =
        reach * rounding::sum_of_sizes(q) + rounding::on_line * half_plane.limit;
    beyond_[i] = std::abs(beyond) <= rounding ? 0 : beyond;
    any_inside |= beyond_[i] < 0;
    any_beyond |= beyond_[i] > 0;
  }
  if (any_inside && any_beyond) cut_along_line(side);
  return any_inside;
}

}  // namespace lepp
