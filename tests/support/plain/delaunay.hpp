#pragma once

#include "lepp/triangulation/mesh.hpp"

namespace lepp::plain {

/// Fills `mesh`, which has vertices and no triangles, with the Delaunay triangulation of its
/// vertices; the convex hull is its boundary, not constrained.
///
/// Sweep: vertices in lexicographic order, each one joined to the hull edges it sees, then
/// Lawson's flips. Simple, exact, without auxiliary points; O(n log n) plus the flips.
/// \pre    no two vertices coincide
/// \return false if all vertices lie on one line (then the mesh stays without triangles)
bool triangulate_vertices(Mesh& mesh);

}  // namespace lepp::plain
