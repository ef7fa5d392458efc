#pragma once

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/raw_triangulation.hpp"

namespace lepp {

/// An edge of the triangulation that an input segment runs along, from a to b.
struct SegmentPiece {
  SegmentId segment;
  VertexId a, b;
};

/// All of them: one owner of each constrained edge, and the further owners of shared ones, each
/// ascending by segment and in order along it.
struct SegmentPieces {
  std::vector<SegmentPiece> first, further;
};

/// Makes every segment of `pslg` a chain of constrained edges of `raw`, and keeps all other edges
/// Delaunay.
///
/// Where the edge is not there yet, the triangles that the segment crosses are removed and the two
/// halves of the hole are triangulated again. A vertex exactly on a segment cuts it; an edge that
/// is constrained already becomes shared.
/// \param vertex_of  for each input point its vertex
/// \throw  InputError where two segments cross where the input has no point
/// \throw  RefusedError if `further` would get more than 10 million pieces and one per segment
/// Cost    O(min(degree of a, degree of b)) for a segment that is an edge already; else the
///         triangles crossed, and the flips that make the hole Delaunay.
SegmentPieces insert_segments(RawTriangulation& raw, const Pslg& pslg,
                              const std::vector<VertexId>& vertex_of, TriangulationReport& report);

}  // namespace lepp
