#pragma once

#include "lepp/terrain/domain_lines.hpp"
#include "lepp/terrain/terrain_domain.hpp"

namespace lepp {

/// What is inside the outline and, if there are clip polygons, inside one of them; inside a ring,
/// or several of one polygon, is what an odd number of them surrounds. Its boundary becomes curve
/// 0, the breaklines inside keep theirs.
/// \throw InputError  nothing is left
/// Cost   that of constrained_delaunay() of the arrangement, whose triangles tell inside from out
TerrainDomain cut_domain(const Arrangement& arrangement, const DomainOptions& options);

}  // namespace lepp
