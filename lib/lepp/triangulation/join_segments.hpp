#pragma once

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Joins the segments of a mesh that came from a file, where each constrained edge is one of its
/// own, back into the straight segments they are likely to have been cut from: a vertex where just
/// two constrained edges end, of the same curves and in line but for rounding, is taken for a point
/// on a segment. Wedges and fans of segments are seen again then (sharp_vertex.hpp).
/// \pre   M1 to M5; all curves are straight, as files have them
/// \post  M5; segments() are the joined ones, each with the curve of its parts
/// Cost   O(triangles + n log n) for n constrained edges
void join_segments_in_line(Mesh& mesh);

}  // namespace lepp
