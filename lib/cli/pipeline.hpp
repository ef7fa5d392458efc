#pragma once

#include <string>

#include "inputs.hpp"
#include "lepp/io/report.hpp"
#include "lepp/refine/refine.hpp"
#include "sizes.hpp"

namespace lepp::cli {

enum class Method {
  unified,  ///< one loop for angles and obtuse angles
  paper,    ///< refinement with midpoints, then the nonobtuse post-process
};

struct MeshOptions {
  RefineOptions refine;
  SizeOptions sizes;
  Method method = Method::unified;
  bool nonobtuse = true;
  bool certify = false;  ///< the Voronoi boxes, even if no bound on angles is asked for
  bool remesh = false;   ///< of a mesh file keep only the outline, interfaces and lines
  TriangulationOptions triangulation;
};

/// A mesh with everything that was found out about it.
struct Meshed {
  Mesh mesh;
  RunReport report;
};

/// From geometry, or from a mesh that exists, to a mesh that was refined, certified and checked
/// from scratch. Fills all of the report but reading and writing.
/// \throw Error  as the stages do
Meshed make_mesh(const Input& input, const MeshOptions& options);

}  // namespace lepp::cli
