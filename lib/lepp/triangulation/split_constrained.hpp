#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "lepp/triangulation/mesh.hpp"
#include "lepp/triangulation/split.hpp"

namespace lepp {

/// What cutting a constrained edge did; no vertex if it could not be cut.
struct ConstrainedSplit {
  std::vector<VertexId> vertices;
  std::vector<TriangleId> changed;  ///< may repeat
};

/// The geometry of a constrained edge, running away from `from`, one of its ends.
struct ConstrainedPiece {
  const Curve* curve = nullptr;  ///< of the mesh's entities; nothing if straight
  CurvePiece piece;
};
ConstrainedPiece piece_from(const Mesh& mesh, HalfEdge e, VertexId from);

/// A double near `p`, a rounded point of the chord of `e`, for which `fits` is true. Where nothing
/// lies across `e`, it is on the chord or on the mesh's side of it, exactly: the mesh may touch
/// itself again an ulp away, and a point outside the chord would reach over there.
/// \param fits  called for `p` and then for points up to four ulps from it; the last time with the
///              point that is returned, if there is one
std::optional<Point> point_near_chord(const Mesh& mesh, HalfEdge e, Point p,
                                      const std::function<bool(Point)>& fits);

/// Cuts constrained edge `e` at the point halfway along it, on its curve if it has one and the
/// mesh stays valid, else on the chord. A point on the chord of a boundary edge never lies outside
/// it, exactly, so a mesh with straight boundaries never grows and cannot come to overlap itself.
/// Nothing happens if a part would be shorter than `floor` or no double fits between.
ConstrainedSplit split_halfway(Mesh& mesh, HalfEdge e, double floor);

/// Cuts `e` at distance `radius` from its end `from`, likewise.
ConstrainedSplit split_at_distance(Mesh& mesh, HalfEdge e, VertexId from, double radius,
                                   double floor);

/// Cuts `e` as refinement must: halfway, unless exactly one end is the center of a fan of sharp
/// wedges. Then every edge of the fan longer than a common radius is cut at that radius, so that
/// no point of one edge encroaches another (synchronised fan, docs/algorithms/sharp_vertices.md).
ConstrainedSplit split_constrained_edge(Mesh& mesh, HalfEdge e, double floor);

}  // namespace lepp
