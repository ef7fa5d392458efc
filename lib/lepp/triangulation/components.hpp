#pragma once

#include <cstdint>
#include <vector>

#include "lepp/triangulation/raw_triangulation.hpp"

namespace lepp {

/// The connected components of the triangles without ghosts, across unconstrained edges.
struct Components {
  std::uint32_t count = 0;
  std::vector<bool> is_open;  ///< by label - 1: an unconstrained hull edge belongs to it
};

/// Labels each triangle with its component, 1 to count, in the order of their first triangles;
/// ghosts get 0. At most two threads are of use. Cost O(triangles).
Components label_components(RawTriangulation& raw, unsigned threads);

}  // namespace lepp
