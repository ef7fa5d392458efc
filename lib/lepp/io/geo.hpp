#pragma once

#include <filesystem>

#include "lepp/geometry/pslg.hpp"
#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Writes geometry for Gmsh: points, straight lines, curve loops, plane surfaces with their holes,
/// points and lines embedded in a surface, and physical groups with names. No mesh sizes.
/// Surfaces are found by triangulating; a curved segment is written as the straight piece that the
/// PSLG has, and pieces of one curve stay together in its groups. If there is a group at all,
/// surfaces of no group form the group "ungrouped": Gmsh would not save their triangles.
/// \throw OutputError; InputError as constrained_delaunay(), or a group name with a double quote
void write_geo(const Pslg& pslg, const std::filesystem::path& path);

/// The same for the outline of a mesh: its constrained edges and point entities.
void write_geo(const Mesh& mesh, const std::filesystem::path& path);

}  // namespace lepp
