#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

enum class Crossings {
  refuse,  ///< an InputError that names both segments and the point
  split,   ///< both segments get a common vertex at the rounded crossing
};

struct TriangulationOptions {
  Crossings crossings = Crossings::refuse;
  /// How many threads may work on large inputs; at most two are used. 0: as many as the machine
  /// has. The mesh does not depend on it.
  unsigned threads = 0;
};

/// What was tidied up on the way from a PSLG to its triangulation. Numbers are the user's.
struct TriangulationReport {
  std::size_t duplicate_points = 0;  ///< merged into an earlier point with the same coordinates
  std::pair<std::int64_t, std::int64_t> first_duplicate{};  ///< (kept, merged)
  std::size_t points_outside = 0;  ///< points outside the domain, not in the mesh
  std::size_t zero_length_segments = 0;
  std::size_t segments_outside = 0;    ///< segments outside the domain, not in the mesh
  std::size_t points_on_segments = 0;  ///< a segment passes exactly through them
  std::size_t overlapping_edges = 0;   ///< edges that two or more segments share
  std::size_t crossings_split = 0;     ///< vertices made where segments cross
  bool convex_hull = false;            ///< no closed area: the domain is the hull of the points
  std::vector<std::string> warnings;   ///< one sentence each, ready to print
  /// For each point of the PSLG the vertex it became, if it is in the mesh.
  std::vector<std::optional<VertexId>> vertex_of_point;
};

struct Triangulation {
  Mesh mesh;
  TriangulationReport report;
};

/// The constrained Delaunay triangulation of a PSLG, without holes and without what lies outside.
///
/// Exact duplicates are merged, segments are cut at points on them, overlapping collinear segments
/// share edges and keep all their tags. Regions are the connected components of the dual graph
/// across unconstrained edges. Every boundary edge is constrained.
/// \return  a mesh with M1 to M6, and what was tidied up
/// \throw   InputError  P1 or P2 broken; crossing segments (refuse); fewer than three points that
///          are not collinear; a hole that reaches the outside; surfaces that overlap or whose
///          boundary is not closed. RefusedError on more than 1.07e9 triangles.
/// Cost     O(n log n) expected for points and segments of a few edges each.
/// Source   docs/algorithms/constrained_delaunay.md [bowyer1981] [amenta2003]
Triangulation constrained_delaunay(const Pslg& pslg, const TriangulationOptions& options = {});

/// A mesh from triangles that exist already, as read from a file.
struct TriangleSoup {
  std::vector<Point> points;
  std::vector<std::array<VertexId, 3>> triangles;  ///< either orientation
  std::vector<SurfaceId> regions;                  ///< one per triangle, or empty: all region 0
  std::vector<Segment> segments;  ///< edges to keep: of curves, or of the user's choice
  Entities entities;
  std::string source;
  std::int64_t base = 0;
  std::vector<std::int64_t> point_numbers;     ///< the user's, or empty: base, base + 1, ...
  std::vector<std::int64_t> triangle_numbers;  ///< likewise
};

/// Joins triangles into a mesh: turns clockwise ones, drops unused points, links neighbours, and
/// constrains the boundary, the edges between regions and the given segments. Nothing is flipped.
/// \return  a mesh with M1 to M5 (M6 is the file's own affair; make_delaunay() restores it)
/// \throw   InputError naming the triangle or edge: an id out of range, a triangle of zero area, an
///          edge of three triangles, two triangles on the same side of an edge, no triangle at all.
///          A segment that is no edge of a triangle is dropped with a warning.
Triangulation mesh_from_triangles(const TriangleSoup& soup);

}  // namespace lepp
