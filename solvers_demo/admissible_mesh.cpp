#include "admissible_mesh.hpp"

#include "lepp/geometry/error.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/voronoi/admissible.hpp"

namespace lepp::demo {

AdmissibleMesh admissible_mesh(const Pslg& pslg, double max_edge) {
  AdmissibleMesh made{constrained_delaunay(pslg).mesh, {}};
  RefineOptions options;
  options.max_edge = max_edge;
  if (!refine(made.mesh, options).goal_reached) {
    throw InputError(pslg.source, "cannot be refined to 30 degrees and nonobtuse boundaries",
                     "allow more vertices");
  }
  made.boxes = voronoi_boxes(made.mesh);
  const Certificate certificate = certify(made.mesh, made.boxes);
  if (!certificate.admissible) {
    throw InputError(pslg.source, certificate.summary(), "refine with nonobtuse boundaries");
  }
  return made;
}

}  // namespace lepp::demo
