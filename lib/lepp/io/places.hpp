#pragma once

#include <vector>

#include "lepp/geometry/point.hpp"
#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// A point well inside each connected part of the mesh, where constrained edges separate parts:
/// the centroid of its widest triangle. In the order of the parts' first triangles.
struct Place {
  Point at;
  SurfaceId region;
};
std::vector<Place> places_of_parts(const Mesh& mesh);

/// A point well inside each hole: an area without mesh that boundary edges close off.
/// The centroid of the hole where that lies well inside; elsewhere, and where a hole may hold
/// islands, found by triangulating boundary edges alone.
/// \throw InputError naming the place where the boundary meets itself, if that keeps it from them
/// Cost O(n), and O(b log b) for the b boundary edges that are triangulated.
std::vector<Point> places_of_holes(const Mesh& mesh);

}  // namespace lepp
