#pragma once

#include <cstddef>

#include "lepp/bisection/refine_where.hpp"
#include "lepp/bisection/region.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/shapes.hpp"

namespace lepp::test {

/// What Theorem 2 starts from: a mesh of good quality, of the unit square.
inline Mesh quality_square() {
  Mesh mesh = constrained_delaunay(unit_square()).mesh;
  RefineOptions options;
  options.max_edge = 0.4;
  refine(mesh, options);
  return mesh;
}

/// What there is after every triangle that meets a disc has got a diameter below eps.
struct DiscCounts {
  std::size_t inside = 0, outside = 0;  ///< vertices that bisection has made
  std::size_t left = 0;                 ///< triangles that are still too large
  bool finished = false;
};

inline DiscCounts refine_disc(Forest& forest, const Disc& disc, double eps) {
  const auto is_to_be_cut = [&](const Mesh& mesh, TriangleId t) {
    return !(diameter(mesh, t) < eps) && meets(disc, mesh.corners(t));
  };
  DiscCounts counts;
  counts.finished = refine_where(forest, is_to_be_cut).finished;
  const Mesh& mesh = forest.mesh();
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    counts.left += is_to_be_cut(mesh, TriangleId(t)) ? 1 : 0;
  }
  for (std::size_t v = forest.root_vertex_count(); v < mesh.vertex_count(); ++v) {
    const Point d = mesh.points()[v] - disc.center;
    (dot(d, d) <= disc.radius * disc.radius ? counts.inside : counts.outside) += 1;
  }
  return counts;
}

}  // namespace lepp::test
