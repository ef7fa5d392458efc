#pragma once

#include <string>
#include <vector>

#include "lepp/voronoi/voronoi_boxes.hpp"

namespace lepp {

/// One broken rule of V1 to V3.
struct BoxViolation {
  std::string rule;   ///< "V1", "V2" or "V3"
  std::string where;  ///< edge or vertex and region, with coordinates
};

/// The certificate that a mesh carries a finite-volume scheme.
struct Certificate {
  bool admissible = false;               ///< V1, V2 and V3 all hold
  std::vector<EdgeFactor> offending;     ///< V1: edges whose factor is negative (exact sign)
  std::vector<BoxViolation> violations;  ///< all broken rules, V1 first
  double largest_area_defect = 0;        ///< V2: worst |sum of boxes - area| / area over regions
  std::string summary() const;           ///< "admissible", or the first violations
};

/// V1 the sign of every edge factor, per edge and region, is >= 0, exactly.
/// V2 the boxes partition each region: their areas sum to the region's to 1e-12 of it.
/// V3 the box of an interface vertex is split per region: one box per vertex and region around it,
///    and each piece of a box lies in a triangle of that region.
/// \pre  `boxes` belongs to `mesh`, which satisfies M1 to M4.  Throws nothing, changes nothing.
Certificate certify(const Mesh& mesh, const VoronoiBoxes& boxes);

/// The same with boxes of its own, which are cut only if V1 holds: without it a box may reach
/// across any number of triangles, and the mesh is not admissible anyway.
Certificate certify(const Mesh& mesh);

}  // namespace lepp
