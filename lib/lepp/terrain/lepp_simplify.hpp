#pragma once

#include <vector>

#include "lepp/terrain/levels.hpp"
#include "lepp/terrain/simplify.hpp"
#include "lepp/terrain/terrain_mesh.hpp"

namespace lepp {

/// Simplification with a bound on angles: each level is inserted into (LeppLoop), cleaned up
/// (TinCleanUp) and then frozen, so that levels are nested.
/// \return triangles below the angle bound, with reasons
std::vector<Unfinished> lepp_simplify(TerrainMesh& terrain, Levels& levels,
                                      const SimplifyOptions& options);

}  // namespace lepp
