#pragma once

#include "lepp/triangulation/raw_triangulation.hpp"

namespace lepp {

/// Fills `raw`, whose points are set, with their Delaunay triangulation.
///
/// Incremental, after Bowyer and Watson: each point removes the triangles whose circumcircle holds
/// it and is joined to the edge of the hole. The order is a biased randomized one (BRIO): a random
/// eighth of the points before the rest, an eighth of those before them, and so on, each round along
/// the spatial order; the walk to a point starts at the one before. Signs are exact; of cocircular
/// points the ones that came first keep their edges.
/// \pre    no two points are equal, neighbours in the array are near each other
/// \return false if all points lie on one line (then there are no triangles)
/// Cost    O(n) expected for most inputs, O(n log n) expected at worst but for the walks.
/// Source  [bowyer1981], [amenta2003] for the order, ghost triangles as in [shewchuk1997]
bool triangulate_points(RawTriangulation& raw);

}  // namespace lepp
