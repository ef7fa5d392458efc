#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "support/oracle_arrangement.hpp"

namespace lepp::test {

/// Constrained Delaunay triangles by their definition, for a dozen points.
struct OracleCdt {
  using Corners = std::array<std::uint32_t, 3>;  ///< of Arrangement::points, ccw, least first

  /// Every triangle that a constrained Delaunay triangulation of the hull may have, ascending:
  /// empty, its corners see each other, and no point that all three see lies strictly inside its
  /// circumcircle.
  std::vector<Corners> triangles;
  /// No such point lies on a circumcircle either: there is one triangulation, `triangles`.
  bool unique = true;
  /// If unique: the triangles that neither the outside nor a hole reaches without crossing a piece;
  /// all of them where the pieces close no face.
  std::vector<Corners> domain;
};

/// \pre no crossings, not collinear. Cost: points^4.
OracleCdt brute_force_cdt(const Arrangement& arrangement, const std::vector<Point>& holes);

}  // namespace lepp::test
