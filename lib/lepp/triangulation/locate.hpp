#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Where a point is in a mesh; exact.
struct Location {
  TriangleId triangle;  ///< one that contains the point, its sides included
  /// The edge of `triangle` that the point lies on, if any (one of two at a vertex).
  std::optional<HalfEdge> on_edge = {};
  /// The corner of `triangle` that the point coincides with, if any.
  std::optional<VertexId> at_vertex = {};
};

/// What locating has cost: triangles, and sides of the mesh, that were looked at. Added up.
struct LocateSteps {
  std::size_t count = 0;
};

/// The triangle that contains `p`: a walk from `hint` across edges that separate it from `p`.
///
/// Each triangle's edges are tried in pseudo-random order, so that the walk does not circle for
/// ever where constrained edges keep the mesh from being Delaunay [devillers2002]. Where it meets
/// a side of the mesh it goes round that boundary loop to the place nearest to `p` and walks on.
/// If that does not help either, every triangle is looked at.
/// \pre    M1 to M3, at least one triangle
/// \return nothing if `p` is outside the mesh
/// Cost    O(1) expected from a hint nearby, O(sqrt n) typical from afar, plus the lengths of the
///         boundary loops met; O(n) where `p` is outside. A Locator answers that faster.
std::optional<Location> locate(const Mesh& mesh, Point p, TriangleId hint = TriangleId(0U),
                               LocateSteps* steps = nullptr);

/// The same for many points: they are taken along a Hilbert curve, each walk starts at the last
/// answer, and a Locator helps out where one meets the boundary.
/// \return one answer for each point, in the order of `points`
/// Cost    O(1) expected each where points are about as dense as the mesh, plus O(n) at the first
///         one outside or behind a hole
std::vector<std::optional<Location>> locate(const Mesh& mesh, std::span<const Point> points,
                                            LocateSteps* steps = nullptr);

/// True if `p` is inside `t` or on its sides.
bool contains(const Mesh& mesh, TriangleId t, Point p);
/// \pre contains(mesh, t, p)
Location location_in(const Mesh& mesh, TriangleId t, Point p);

/// Where a walk towards a point ended.
struct WalkEnd {
  TriangleId triangle;           ///< the last one
  bool found = false;            ///< it contains the point
  std::optional<HalfEdge> side;  ///< the side of the mesh that barred the way, if one did
};
/// The walk alone: at most `most_steps` triangles, no help where it meets a side.
WalkEnd walk(const Mesh& mesh, Point p, TriangleId start, std::size_t most_steps,
             LocateSteps& steps);

}  // namespace lepp
