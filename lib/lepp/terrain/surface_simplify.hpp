#pragma once

#include "lepp/terrain/levels.hpp"
#include "lepp/terrain/simplify.hpp"
#include "lepp/terrain/terrain_mesh.hpp"

namespace lepp {

/// SimplifyBy::lepp by the metric of the surface. SurfaceLoop goes on from a planar TIN, and has
/// nothing to do where the surface is level. With Effort::fast that is the domain's mesh with its
/// angles in plan mended, so that every sample is fitted by LEPP in space, as in the paper; else it
/// is the planar simplification, cleaned up, to the same error: half as many vertices.
/// \param report  gets `unfinished`, here triangles with an angle in plan below 15 degrees or the
///                bound, and what `surface` says of violations
void surface_simplify(TerrainMesh& terrain, Levels& levels, const SimplifyOptions& options,
                      SimplifyReport& report);

/// Notes what angles the triangles of a TIN of `grid` have in space. Cost O(triangles)
void note_angles(const HeightGrid& grid, const Tin& tin, double min_angle_deg,
                 SurfaceReport& report);

}  // namespace lepp
