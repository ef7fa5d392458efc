#pragma once

#include <optional>

#include "lepp/terrain/samples_inside.hpp"
#include "lepp/terrain/simplify.hpp"
#include "lepp/terrain/terrain_domain.hpp"
#include "terrain_run.hpp"

namespace lepp::cli {

/// What the stages made of a grid, not judged yet.
struct TerrainWork {
  TerrainDomain domain;
  std::optional<SampleSet> inside;  ///< of a clipped domain: the samples in it
  SimplifyReport simplified;        ///< with what --nonobtuse left unfinished
  std::optional<Mesh> in_world;     ///< of --nonobtuse: as it was refined there
  bool judged_in_world = true;      ///< what --nonobtuse promises holds in world coordinates
  MadeTerrain made;                 ///< TINs without figures, but for those before a fit

  TerrainError measured(const HeightGrid& grid, const Tin& tin) const {
    return measure_error(grid, tin, inside ? &*inside : nullptr);
  }
};

/// Completes the TINs and the report: errors are measured anew, in world coordinates too meshes are
/// checked, and whatever is claimed is checked from scratch.
MadeTerrain judged(const HeightGrid& grid, const GridPlace& place, const TerrainJob& job,
                   TerrainWork work);

}  // namespace lepp::cli
