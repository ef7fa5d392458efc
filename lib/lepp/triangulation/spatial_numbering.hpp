#pragma once

#include <cstdint>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Numbers the vertices and triangles of a mesh along a Hilbert curve, for work that goes from one
/// place to the next and would otherwise wait for memory at each: input points may come in any
/// order, and they keep it. Vertices of the input stay before the others.
class SpatialNumbering {
 public:
  /// \pre  M1 to M4, input vertices first.  Cost O(n): about as much as reading the mesh ten times
  explicit SpatialNumbering(Mesh& mesh);

  /// Gives the input vertices their own numbers back. Others, and triangles, keep their new ones.
  /// \pre  since the constructor no input vertex was removed
  void undo();

 private:
  Mesh& mesh_;
  std::vector<std::uint32_t> input_;  // the old number of each input vertex
};

}  // namespace lepp
