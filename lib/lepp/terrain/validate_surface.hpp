#pragma once

#include <vector>

#include "lepp/terrain/height_grid.hpp"
#include "lepp/terrain/surface_report.hpp"
#include "lepp/terrain/tin.hpp"
#include "lepp/triangulation/validate.hpp"

namespace lepp {

/// What a TIN by the surface metric claims besides M1 to M5.
struct SurfaceClaims {
  double bound = 0;                              ///< of the error, as SurfaceReport has it
  double plan_angle_deg = 15;                    ///< what flips had to keep in plan
  std::vector<SphereViolation> violations = {};  ///< as SurfaceReport lists them
};

/// S1: two angles opposite an edge, in space, are at most 180 degrees in sum, or the edge is
/// listed. S2: a listed edge is there, once, breaks the criterion, and the rule named keeps it.
/// Shares nothing but the predicates with what it checks; angles up to 1e-6 degrees, errors up to
/// 1e-9 of themselves.
/// \pre  the mesh satisfies M1 to M5.  Cost O(triangles), and the samples at edges kept by `error`
MeshReport validate_surface(const HeightGrid& grid, const Tin& tin, const SurfaceClaims& claims);

}  // namespace lepp
