#pragma once

#include <cstddef>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

struct NonobtuseOptions {
  /// Largest number of vertices, all included; 0 means 50 * (vertices + 1000).
  std::size_t max_vertices = 0;
};

struct NonobtuseReport {
  bool goal_reached = false;  ///< no obtuse angle opposite a constrained edge is left
  std::size_t steiner_points = 0;
  std::size_t one_edge_boundary = 0;   ///< N1b: 1-edge boundary obtuse triangles met
  std::size_t one_edge_interface = 0;  ///< N1i: obtuse angles at interface edges met
  std::size_t two_edge = 0;            ///< 2-edge obtuse triangles with interior smallest edge met
  std::vector<TriangleId> obtuse;      ///< triangles still obtuse, ascending
};

/// The paper's post-process (its section 7): removes every angle above 90 degrees opposite a
/// boundary or interface edge by inserting points on constrained edges only. Angles below the
/// bound of an earlier refine() may appear near them.
/// \pre   M1 to M6.  \return always, with a mesh that satisfies M1 to M6
/// Source [hitschfeld2002] as rebuilt in docs/algorithms/nonobtuse.md
NonobtuseReport make_boundary_nonobtuse(Mesh& mesh, const NonobtuseOptions& options = {});

}  // namespace lepp
