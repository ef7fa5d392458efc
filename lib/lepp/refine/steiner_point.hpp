#pragma once

#include <optional>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Where a new point goes. The first two are rule C's: at the end of the target's LEPP, and a
/// constrained edge that is second longest there is cut. The others look for a place near the
/// target's off-centre, and cut a constrained edge only where a point would encroach it.
enum class Placement {
  centroid,   ///< average of the pair's four vertices
  midpoint,   ///< midpoint of the terminal edge: the paper's
  offcentre,  ///< a good place in the cavity of the target's off-centre, else the off-centre
  best,       ///< the same in the cavities of several candidates
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
