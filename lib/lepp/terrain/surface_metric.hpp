#pragma once

#include <array>
#include <cmath>

#include "lepp/refine/angle_test.hpp"
#include "lepp/terrain/terrain_mesh.hpp"

namespace lepp {

/// A place in space: grid space, and a height in the same unit, widths of a cell.
struct SpacePoint {
  double x = 0, y = 0, z = 0;
  Point plan() const { return {x, y}; }
};

inline SpacePoint operator-(const SpacePoint& a, const SpacePoint& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline double dot(const SpacePoint& a, const SpacePoint& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline SpacePoint cross(const SpacePoint& a, const SpacePoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Where heights are equal, the same double as in the plane.
inline double squared_distance(const SpacePoint& a, const SpacePoint& b) {
  const SpacePoint d = b - a;
  return d.x * d.x + d.y * d.y + d.z * d.z;
}

/// Edge a -> b of two triangles: c is the apex on its left, d the one on its right, as in flip().
struct Quad {
  SpacePoint a, b, c, d;
};

/// The sphere criterion as a sum of angles: true if those at c and d, in space, are more than 180
/// degrees. In a skew quadrilateral all four have at most 360, so that a and b then do not. Where
/// the surface is flat this says that d lies inside the circumcircle of a, b, c, by more than
/// rounding. The same answer from either side of the edge.
bool breaks_sphere(const Quad& quad);

/// cos^2 of the smallest angle in space: from 1/4 (equilateral) to 1 (flat).
inline double badness(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c) {
  const auto r = AngleTest::of_smallest(squared_distance(a, b), squared_distance(b, c),
                                        squared_distance(c, a));
  return r.part / r.whole;
}

/// cos of the angle between the planes of (a, b, c) and (b, a, d): 1 if they are one plane.
double cos_dihedral(const Quad& quad);

/// Lengths in space on a TIN that is being worked on.
class SurfaceMetric {
 public:
  explicit SurfaceMetric(const TerrainMesh& terrain)
      : terrain_(terrain), per_height_(1 / terrain.grid().cell_width) {}

  SpacePoint at(VertexId v) const {
    const Point p = terrain_.mesh().point(v);
    return {p.x, p.y, terrain_.tin().heights[v.index()] * per_height_};
  }
  /// Where a vertex inserted at `p` would be.
  SpacePoint at(Point p) const { return {p.x, p.y, terrain_.height_of(p) * per_height_}; }

  std::array<SpacePoint, 3> corners(TriangleId t) const {
    const auto& [a, b, c] = terrain_.mesh().vertices(t);
    return {at(a), at(b), at(c)};
  }
  double badness(TriangleId t) const {
    const auto [a, b, c] = corners(t);
    return lepp::badness(a, b, c);
  }
  double squared_length(HalfEdge e) const {
    return squared_distance(at(terrain_.mesh().origin(e)), at(terrain_.mesh().destination(e)));
  }
  /// \pre `e` has a twin
  Quad quad(HalfEdge e) const {
    const Mesh& mesh = terrain_.mesh();
    return {at(mesh.origin(e)), at(mesh.destination(e)), at(mesh.apex(e)),
            at(mesh.apex(*mesh.twin(e)))};
  }

  /// As in the plane (lepp.hpp), with lengths in space; ties go by the same coordinates, so that a
  /// LEPP strictly grows in this key as well.
  HalfEdge longest_edge(TriangleId t) const;
  HalfEdge terminal_edge(TriangleId start) const;

 private:
  const TerrainMesh& terrain_;
  double per_height_;
};

/// Spreads a plan so that lengths in one tilted plane become true: the symmetric root of that
/// plane's metric, I + g g^T for its slope g. A level plane is left as it is, bit for bit.
class SlopeMap {
 public:
  /// The plane of a closed chain of places that is counter-clockwise in plan: its vector area is
  /// the plane's normal.
  template <class Places>
  explicit SlopeMap(const Places& chain) {
    SpacePoint normal;
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
      const SpacePoint n = cross(chain[i] - chain[0], chain[i + 1] - chain[0]);
      normal = {normal.x + n.x, normal.y + n.y, normal.z + n.z};
    }
    slope_ = {-normal.x / normal.z, -normal.y / normal.z};
    const double squared = dot(slope_, slope_), stretch = std::sqrt(1 + squared);
    if (!(squared > 0)) return;
    there_ = (stretch - 1) / squared;
    back_ = (1 / stretch - 1) / squared;
  }
  Point to_plane(Point p) const { return p + (there_ * dot(slope_, p)) * slope_; }
  Point to_plan(Point p) const { return p + (back_ * dot(slope_, p)) * slope_; }

 private:
  Point slope_;
  double there_ = 0, back_ = 0;
};

}  // namespace lepp
