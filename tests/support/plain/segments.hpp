#pragma once

#include "lepp/triangulation/constrained_delaunay.hpp"

namespace lepp::plain {

/// Makes every segment of `mesh.segments()` a chain of constrained edges of the triangulated
/// convex hull `mesh`, and restores the Delaunay property around them.
///
/// Each segment is walked from end to end; edges it crosses are flipped away [sloan1993]; a vertex
/// exactly on it cuts it; an edge that is constrained already becomes shared.
/// \pre    M1 to M3, the mesh fills its convex hull; segment ends are vertices
/// \throw  InputError where two segments cross
void insert_segments(Mesh& mesh, const Pslg& pslg, TriangulationReport& report);

}  // namespace lepp::plain
