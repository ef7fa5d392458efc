#pragma once

#include <vector>

#include "lepp/bisection/forest.hpp"

namespace lepp {

/// The vertices that bisections have made out of the roots of a forest, in an order in which they
/// can be made, with the ids of its mesh: the levels of a multigrid method, also after coarsening.
/// As long as nothing is coarsened, Refinement::vertices of one call after the other are such a
/// list, for nothing. Cost  O(triangles): after a first call of coarsen() for all triangles, only
/// what changed, and
///       what touches it, is tried again
std::vector<NewVertex> vertices_made(Forest forest);

}  // namespace lepp
