#pragma once

#include "lepp/terrain/levels.hpp"
#include "lepp/terrain/simplify.hpp"
#include "lepp/terrain/terrain_mesh.hpp"

namespace lepp {

/// Greedy insertion [garland1995]: as long as a triangle is off by more than the bound, the worst
/// sample of the triangle that is off most becomes a vertex. The mesh stays constrained Delaunay.
/// Ends: each turn makes one more sample a vertex, or gives up a triangle, for good unless a
/// neighbour changes, because its worst sample is on a line that may not be cut there.
/// \param error_of_prefix  gets the largest error at the start and after each insertion; the last
///                         one only if it is above the bound, else less
void greedy(TerrainMesh& terrain, Levels& levels, std::vector<double>& error_of_prefix);

}  // namespace lepp
