#pragma once

#include <optional>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Where the new point of a terminal pair goes.
enum class Placement {
  centroid,  ///< average of the pair's four vertices
  midpoint,  ///< midpoint of the terminal edge: the paper's
};

/// What to insert at the end of a LEPP: a cut of constrained edge `edge`, or a point on
/// unconstrained `edge`, or a point inside `triangle`.
struct SteinerPoint {
  enum class Where { constrained_edge, edge, triangle };
  Where where;
  HalfEdge edge;        ///< for the first two
  TriangleId triangle;  ///< for the last
  Point point;          ///< for the last two
};

/// Rule C for the terminal edge of a LEPP and its one or two triangles: a constrained terminal edge
/// is cut; else a constrained second-longest edge of a terminal triangle is cut, without which
/// right triangles on the boundary would repeat at half the scale for ever; else the point is
/// placed by `placement`.
/// \pre    `terminal` is the terminal edge of a LEPP
/// \return nothing if no double lies strictly inside the triangles where the point should go
/// Source  [rivara1999] Figure 5; docs/algorithms/refine.md tells how it is read
std::optional<SteinerPoint> steiner_point(const Mesh& mesh, HalfEdge terminal, Placement placement);

}  // namespace lepp
