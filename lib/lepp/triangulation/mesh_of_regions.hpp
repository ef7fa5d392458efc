#pragma once

#include <vector>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/raw_triangulation.hpp"
#include "lepp/triangulation/regions.hpp"
#include "lepp/triangulation/segments.hpp"

namespace lepp {

/// Turns the triangulated plane into a mesh of the parts that belong to a surface: vertices in
/// input order, without ghosts, holes and outside, every boundary edge constrained. The triangles
/// are moved within their array, not copied; `raw` is used up.
///
/// Each piece becomes a segment of its own: before refinement the vertices are those of the input,
/// so a segment ends at every one it passes through, and edges that meet there are known to meet.
/// \param threads    at most two are of use; the result does not depend on it
/// \param vertex_of  for each input point its vertex in `raw`
Mesh mesh_of_regions(RawTriangulation raw, Regions regions, const Pslg& pslg, SegmentPieces pieces,
                     std::vector<VertexId> vertex_of, TriangulationReport& report,
                     unsigned threads);

}  // namespace lepp
