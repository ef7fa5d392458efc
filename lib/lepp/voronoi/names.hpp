#pragma once

#include <string>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// What violations call a region, and a vertex, which need not exist.
std::string name_of(const Mesh& mesh, SurfaceId region);
std::string name_of(const Mesh& mesh, VertexId v);

}  // namespace lepp
