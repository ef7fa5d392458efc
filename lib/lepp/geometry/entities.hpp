#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "lepp/geometry/curve.hpp"
#include "lepp/geometry/ids.hpp"

namespace lepp {

/// A physical group: a named set of points, curves or surfaces that the solver knows by `tag` or
/// by `name`. The same tag may exist once per dimension.
struct PhysicalGroup {
  int dimension = 0;  ///< 0 points, 1 curves, 2 surfaces
  int tag = 0;        ///< the user's number, > 0 in Gmsh files
  std::string name;   ///< empty if the user gave none
};

/// A point the user named: embedded, or in a physical group. Its vertex is Pslg/Mesh data.
struct PointEntity {
  int tag = 0;  ///< the user's number
  VertexId vertex;
  std::vector<GroupId> groups;
};

/// A curve of the input: what a segment is a piece of.
struct CurveEntity {
  int tag = 0;  ///< the user's number (the boundary marker in a .poly file)
  std::vector<GroupId> groups;
  Curve geometry;  ///< straight unless the input says otherwise
  /// The surfaces whose boundary this curve belongs to, once per occurrence. Crossing a segment of
  /// the curve enters or leaves each of them; a curve embedded in a surface is not in the list.
  std::vector<SurfaceId> bounds;
};

/// A surface of the input: what the field calls a region or material.
struct SurfaceEntity {
  int tag = 0;  ///< the user's number (the regional attribute in a .poly file)
  std::vector<GroupId> groups;
  double attribute = 0;  ///< the regional attribute of a .poly file, else the tag
  double max_area = std::numeric_limits<double>::infinity();  ///< wanted triangle area, > 0
  double max_edge = std::numeric_limits<double>::infinity();  ///< longest edge wanted, > 0
};

/// Everything the user gave a name or a number. Segments, edges and triangles point here, so no
/// tag is ever found again from coordinates.
struct Entities {
  std::vector<PhysicalGroup> groups;
  std::vector<PointEntity> points;
  std::vector<CurveEntity> curves;
  std::vector<SurfaceEntity> surfaces;

  const PhysicalGroup& operator[](GroupId id) const { return groups[id.index()]; }
  const PointEntity& operator[](PointEntityId id) const { return points[id.index()]; }
  const CurveEntity& operator[](CurveId id) const { return curves[id.index()]; }
  const SurfaceEntity& operator[](SurfaceId id) const { return surfaces[id.index()]; }
};

}  // namespace lepp
