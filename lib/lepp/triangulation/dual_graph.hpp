#pragma once

#include <cstdint>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// The connected components of the dual graph: triangles joined across unconstrained edges.
struct DualComponents {
  std::vector<std::uint32_t> of_triangle;  ///< component of each triangle
  std::uint32_t count = 0;
};

/// Numbered by their first triangle. \pre M1 to M3. Cost O(triangles).
DualComponents dual_components(const Mesh& mesh);

}  // namespace lepp
