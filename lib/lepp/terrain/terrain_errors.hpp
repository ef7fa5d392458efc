#pragma once

#include <cstddef>

#include "lepp/terrain/error_heap.hpp"
#include "lepp/terrain/terrain_mesh.hpp"
#include "lepp/triangulation/relocate.hpp"

namespace lepp {

/// The triangles of a TIN that are off by more than `limit`. Cost O(triangles)
ErrorHeap errors_above(const TerrainMesh& terrain, double limit);

/// The largest error of any triangle. Cost O(triangles)
double largest_error(const TerrainMesh& terrain);
/// The same, but the limit of `heap` at most where that is empty, because what
/// is above it then has been given up. Cost O(triangles)
double largest_error(const TerrainMesh& terrain, const ErrorHeap& heap);

/// The largest error of the triangles of a star, as it is in the mesh.
double largest_error(const TerrainMesh& terrain, const Star& star);

/// What it would be with the center at `p`, at the height that a vertex gets there.
/// Cost O(samples)
double error_of_star(const TerrainMesh& terrain, const Star& star, Point p);

/// The largest error of samples at vertices and on hard lines, which no insertion mends.
/// Cost O(triangles + samples on lines)
double error_at_lines(const TerrainMesh& terrain);

/// How many vertices a run may make at most, that begins with this mesh: eight times the samples,
/// and what refine() gives a domain. No real grid comes near.
std::size_t vertex_budget(const TerrainMesh& terrain);

}  // namespace lepp
