#pragma once

#include "lepp/voronoi/voronoi_boxes.hpp"

namespace lepp::demo {

/// A mesh and the boxes that its certificate was made from.
struct AdmissibleMesh {
  Mesh mesh;
  VoronoiBoxes boxes;
};

/// The whole pipeline on a drawing: triangulates, refines to 30 degrees with no angle above 90
/// degrees opposite a boundary or interface edge and no edge longer than `max_edge`, certifies.
/// \throw InputError  if the goal is out of reach or the mesh is not admissible
AdmissibleMesh admissible_mesh(const Pslg& pslg, double max_edge);

}  // namespace lepp::demo
