#pragma once

#include "lepp/triangulation/raw_triangulation.hpp"

namespace lepp {

struct DelaunayOptions {
  unsigned threads = 1;  ///< at most two are of use; the result does not depend on it
  /// From this number of points on, two halves are triangulated and merged. At least 8.
  std::size_t halve_from = 32;
};

/// Fills `raw`, whose points are set, with their Delaunay triangulation.
///
/// Incremental, after Bowyer and Watson: each point removes the triangles whose circumcircle holds
/// it and is joined to the edge of the hole. The order is a biased randomized one (BRIO): a random
/// eighth of the points before the rest, an eighth of those before them, and so on, each round
/// along the spatial order; the walk to a point starts at the one before. Many points are divided
/// into two halves, which two threads can triangulate at the same time, and merged; halves that lie
/// on one line are not merged: then all points are inserted together. Signs are exact; of
/// cocircular points the ones that came first keep their edges.
/// \pre    1 <= points < 2^29; no two are equal, neighbours in the array are near each other
/// \return false if all points lie on one line (then there are no triangles)
/// Cost    O(n) expected for most inputs; O(n log n) expected at worst, but for the walks
/// Source  [bowyer1981]; [amenta2003] for the order, [guibas1985] for merging, ghost triangles as
///         in [shewchuk1997]
bool triangulate_points(RawTriangulation& raw, const DelaunayOptions& options = {});

}  // namespace lepp
