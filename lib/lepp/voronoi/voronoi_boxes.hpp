#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// The part of a vertex's Voronoi box (control volume) that lies in one region: the points of the
/// region that are nearer to `vertex` than to any other vertex of the region. Constrained edges are
/// walls: a box does not reach beyond one, nor do vertices there bound it.
struct VoronoiBox {
  VertexId vertex;
  SurfaceId region;
  double area = 0;  ///< > 0
  /// Convex counter-clockwise pieces, at least one per triangle that the box meets:
  /// VoronoiBoxes::piece(first_piece) ... piece(first_piece + pieces - 1). They do not overlap and
  /// together are the box.
  std::uint32_t first_piece = 0, pieces = 0;
};

/// The common face of two boxes inside one region.
struct VoronoiFace {
  VertexId k, l;  ///< the two boxes it separates, k < l; kl is an edge of the mesh
  SurfaceId region;
  double length = 0;    ///< sigma_kl, measure of the face, >= 0
  double distance = 0;  ///< h_kl = |x_k - x_l|, > 0
};

/// The Voronoi boxes of a mesh, clipped to the domain and to each region, and their faces.
/// Sorted by vertex, then region; faces by k, l, region.
struct VoronoiBoxes {
  std::vector<VoronoiBox> boxes;
  std::vector<VoronoiFace> faces;
  std::vector<std::uint32_t> piece_begin;  ///< pieces + 1 offsets into `corners`
  std::vector<Point> corners;
  std::vector<TriangleId> piece_triangle;  ///< the triangle that a piece was cut from

  std::span<const Point> piece(std::uint32_t i) const {
    return {corners.data() + piece_begin[i], piece_begin[i + 1] - piece_begin[i]};
  }
};

/// Cuts from the triangles around each vertex, and from those it sees beyond them, what is nearer
/// to it than to its neighbours. Uses no cotangent and no angle, so it is an independent check of
/// edge_factors(). The boxes make a finite-volume scheme only if the mesh is admissible.
/// \pre  `mesh` satisfies M1 to M4.  Cost O(triangles) for bounded vertex degree.
/// docs/algorithms/voronoi.md has the steps and the rounding.
VoronoiBoxes voronoi_boxes(const Mesh& mesh);

/// Area of each vertex's box, all regions together; indexed by vertex.
std::vector<double> box_areas(const Mesh& mesh, const VoronoiBoxes& boxes);

/// The edge factor (half the sum of cotangents; sigma_kl / h_kl where the mesh is admissible) that
/// an edge has in one region.
struct EdgeFactor {
  VertexId k, l;  ///< k < l
  SurfaceId region;
  double factor = 0;     ///< the double value
  int sign = 0;          ///< the exact sign
  double angle_deg = 0;  ///< the sum of the angles opposite the edge inside the region
};

/// Edge factors per edge and region, sorted by k, l, region. An interior edge that is constrained
/// counts each side on its own, because each side must be >= 0 there; then it has two entries.
/// \pre  M1 to M4.  Source [eymard2000]; docs/algorithms/voronoi.md
std::vector<EdgeFactor> edge_factors(const Mesh& mesh);

/// Those of edge_factors() whose sign is -1, without working out the others: a mesh has few or
/// none. \pre  M1 to M4.  Cost O(triangles) and n log n for n such edges
std::vector<EdgeFactor> negative_edge_factors(const Mesh& mesh);

}  // namespace lepp
