#pragma once

#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// A terrain as a triangulated irregular network: a mesh and a height at each vertex. The
/// simplification works on one in grid space (height_grid.hpp); files hold it in world coordinates.
struct Tin {
  Mesh mesh;
  std::vector<double> heights;  ///< one per vertex
};

}  // namespace lepp
