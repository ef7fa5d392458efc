#pragma once

#include <cstdint>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// The sharp vertices at which large angles are left alone: where triangles between the edges of
/// a fan (sharp_vertex.hpp) are not bettered though an angle of theirs is above the bound, because
/// that has been seen to cut the fan again and again. docs/algorithms/refine.md
class LeftAlone {
 public:
  static LeftAlone nowhere(const Mesh& mesh) { return LeftAlone(mesh, 0); }
  static LeftAlone everywhere(const Mesh& mesh) { return LeftAlone(mesh, 1); }

  /// True if `t` has a corner at such a vertex, or on an input segment that ends at one.
  bool contains(const Mesh& mesh, TriangleId t) const;

  /// Adds each vertex at which `attempt` has a much shorter constrained edge than `plain`, the mesh
  /// that refinement makes of the same start with all of them left alone. Cost O(triangles)
  /// \return whether there was one
  bool add_shrunken(const Mesh& attempt, const Mesh& plain);

 private:
  LeftAlone(const Mesh& mesh, std::uint8_t all) : at_(mesh.vertex_count(), all) {}

  std::vector<std::uint8_t> at_;  // by vertex of the start
};

}  // namespace lepp
