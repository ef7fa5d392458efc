#pragma once

#include <cstdint>
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

  const std::vector<Corner>& corners() const { return corners_; }
  const Corner& after(std::size_t i) const {
    return corners_[i + 1 == corners_.size() ? 0 : i + 1];
  }

  /// The triangle abc; edge i is opposite corner i, as in a Mesh.
  void start_with(Point a, Point b, Point c);

  /// Keeps the part inside `half_plane`; the new side is labelled `side`.
  /// A corner that is on its line up to rounding counts as on it, so no part thinner than rounding
  /// comes off or is left over.
  /// \return  false if nothing would be left; the polygon is then as it was
  [[nodiscard]] bool keep(const HalfPlane& half_plane, Side side);

  /// Area, with differences taken from the first corner.
  double area() const;

 private:
  void cut_along_line(Side side);

  std::vector<Corner> corners_;
  std::vector<Corner> kept_;    // scratch
  std::vector<double> beyond_;  // per corner: > 0 outside the half-plane, < 0 inside
};

}  // namespace lepp
