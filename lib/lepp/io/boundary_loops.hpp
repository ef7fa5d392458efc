#pragma once

#include <optional>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// A closed walk along boundary edges, the mesh on the left of each, around one area without mesh.
struct BoundaryLoop {
  std::vector<HalfEdge> sides;  ///< each starts where the one before it ends
  double area = 0;              ///< > 0 around mesh, < 0 around a hole
  double uncertainty = 0;       ///< how far rounding may have moved `area`, generously
};

/// The boundary as loops. Where the mesh touches itself in a vertex, a loop stays with the area
/// without mesh, so each bounded one has exactly one loop of negative area, and beside it one of
/// positive area for each island inside that does not touch it.
/// \pre  M1 to M4.  Cost O(triangles)
std::vector<BoundaryLoop> boundary_loops(const Mesh& mesh);

/// The same edges as loops that pass each vertex once, as solvers read them: one that passes a
/// vertex again is cut there. An island that touches its hole's rim has a loop of its own, too.
/// \pre  M1 to M4.  Cost O(triangles)
std::vector<BoundaryLoop> simple_boundary_loops(const Mesh& mesh);

/// The centroid of the area inside a loop that goes around a hole, if it lies well inside: further
/// from the loop than a hundredth of the square root of the area (its being inside is exact).
std::optional<Point> centroid_inside(const Mesh& mesh, const BoundaryLoop& hole);

}  // namespace lepp
