#pragma once

#include <optional>
#include <utility>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Two boundary edges that cross, touch or overlap elsewhere than at a common end: the mesh
/// overlaps itself there, or a vertex hangs in the middle of an edge. M1 to M4 look at a triangle
/// and its neighbours only and do not see it.
/// \pre   M1 to M4
/// Cost   O(triangles + b log b) in practice for b boundary edges; near_pairs.hpp
std::optional<std::pair<HalfEdge, HalfEdge>> first_boundary_meeting(const Mesh& mesh);

/// True if an edge of the boundary is a piece of a curve that is not straight. Only then can
/// cutting edges make a mesh grow (split_constrained.hpp), and so overlap itself. Cost O(triangles)
bool has_bent_boundary(const Mesh& mesh);

}  // namespace lepp
