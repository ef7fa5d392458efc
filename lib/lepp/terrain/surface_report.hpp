#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// What keeps an edge whose two opposite angles, measured in space, are more than 180 degrees in
/// sum, although the other diagonal would do better. The first that holds, in this order.
enum class KeptBy {
  constraint,  ///< it is constrained: a side of the domain, or a breakline
  shape,       ///< its quadrilateral is not strictly convex in plan: it cannot be flipped
  angle,       ///< the smallest of the angles in space would not rise
  plan_angle,  ///< an angle in plan would be below what is promised, and not above what it is
  error,       ///< its triangles would be off by more than the bound, and than they are
};
std::string to_string(KeptBy rule);

/// An edge that breaks the sphere criterion, seen from the triangle with the lower id.
struct SphereViolation {
  HalfEdge edge;
  KeptBy kept_by = KeptBy::constraint;
  friend bool operator==(const SphereViolation&, const SphereViolation&) = default;
};

/// The TIN as a surface in space, heights and cells in one unit.
struct SurfaceReport {
  double mean_min_angle_deg = 0;  ///< of the smallest angles of all triangles
  double min_angle_deg = 0;       ///< the smallest angle of all
  std::size_t below_bound = 0;    ///< triangles with an angle below the bound asked for
  // Of the surface metric alone:
  std::vector<SphereViolation> violations = {};  ///< all that are left, ascending by edge
  double bound = 0;  ///< of the error, at the level where it ended: what rule `error` goes by
  double plan_angle_deg = 0;  ///< what rule `plan_angle` goes by
  std::size_t tame = 0;       ///< vertices inserted by the metric of space
  std::size_t untame = 0;     ///< and by that of the plan, where the surface bends too much
};

}  // namespace lepp
