#pragma once

#include <optional>

#include "lepp/terrain/simplify.hpp"
#include "lepp/terrain/terrain_domain.hpp"
#include "terrain_run.hpp"

namespace lepp::cli {

/// What the stages made of a grid, not judged yet.
struct TerrainWork {
  TerrainDomain domain;
  SimplifyReport simplified;     ///< with what --nonobtuse left unfinished
  std::optional<Mesh> in_world;  ///< of --nonobtuse: as it was refined there
  bool judged_in_world = true;   ///< what --nonobtuse promises holds in world coordinates
  MadeTerrain made;              ///< TINs without figures, but for those before a fit
};

/// Completes the TINs and the report: errors are measured anew, in world coordinates too meshes are
/// checked, and whatever is claimed is checked from scratch.
MadeTerrain judged(const HeightGrid& grid, const GridPlace& place, const TerrainJob& job,
                   TerrainWork work);

}  // namespace lepp::cli
