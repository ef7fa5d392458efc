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

  /// Keeps the part inside `half_plane`; the new side is labelled `side`.
  /// A corner that is on its line up to rounding counts as on it, so no part thinner than rounding
  /// comes off or is left over.
  /// \return  false if nothing would be left; the polygon is then as it was
  [[nodiscard]] bool keep(const HalfPlane& half_plane, Side side);

  /// Area, with differences taken from the first corner.
  double area() const;

 private:
  void cut_along_line(Side side);

  // Room for more corners than there are: a cut then writes without asking.
  std::size_t count_ = 0;
  std::vector<Corner> corners_ = std::vector<Corner>(3);
  std::vector<Corner> kept_;  // scratch
  std::vector<double> beyond_ =
      std::vector<double>(3);  // per corner: > 0 outside the half-plane, < 0 inside
};

// Inline: most cuts take nothing off, and to find that out is all they do.

inline void CutPolygon::start_with(Point a, Point b, Point c, std::uint32_t first) {
  const std::uint32_t second = first == 2 ? 0 : first + 1;
  const std::uint32_t third = first == 0 ? 2 : first - 1;
  count_ = 3;
  corners_[0] = {a, {Side::Kind::edge, third}};
  corners_[1] = {b, {Side::Kind::edge, first}};
  corners_[2] = {c, {Side::Kind::edge, second}};
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
