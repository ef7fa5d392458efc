#pragma once

#include <cstddef>
#include <span>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Removes the Steiner points around some triangles, so that refinement can begin there anew:
/// those of the nearest `triangles` triangles of each, as far as unconstrained and constrained
/// edges of the mesh lead. The mesh stays constrained Delaunay.
/// \return how many were removed
std::size_t clear_around(Mesh& mesh, std::span<const TriangleId> centers, std::size_t triangles);

}  // namespace lepp
