#pragma once

#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// A terrain as a triangulated irregular network: a mesh and a height at each vertex. The
/// simplification works on one in grid space (height_grid.hpp); files hold it in world coordinates.
struct Tin {
  Mesh mesh;
  std::vector<double> heights;  ///< one per vertex
  /// By segment of the mesh (Mesh::segments()): a line asks for the heights along it, which are
  /// linear from end to end. Empty: none does. Segments stay what they are while vertices come, go,
  /// move to the world and get other numbers (hard_lines.hpp).
  std::vector<bool> hard_segments = {};
};

}  // namespace lepp
