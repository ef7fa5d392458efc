#pragma once

#include "lepp/terrain/height_grid.hpp"
#include "lepp/terrain/sample_set.hpp"
#include "lepp/terrain/terrain_domain.hpp"

namespace lepp {

/// The samples inside the outline of a domain, with data or not: those from which an odd number of
/// its segments lies to the west, by exact signs. Of those on the outline it may have some. Knows
/// nothing of triangles, so that it can tell which samples a mesh has lost.
/// Cost  O(samples / 64) and that of sorting where the outline crosses lines of samples
SampleSet samples_inside(const HeightGrid& grid, const TerrainDomain& domain);

}  // namespace lepp
