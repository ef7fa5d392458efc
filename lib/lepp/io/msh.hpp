#pragma once

#include <filesystem>
#include <span>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// The ASCII formats of Gmsh that solvers read.
enum class MshFormat {
  msh41,  ///< 4.1: entities with their groups, an entity may be in several
  msh22,  ///< 2.2, header exactly "2.2 0 8": one group per entity
};

/// Writes vertices, triangles counter-clockwise, a line per constrained edge and curve that owns
/// it, and a point per point entity, with physical groups and their names.
/// Vertex i is node i + 1. Entities keep their tags where these are positive and not taken.
/// Constrained edges of no curve belong to two curves without group, one for the boundary and one
/// for the inside.
/// Elements of no group: format 2.2 gives them physical tag 0. Format 4.1 has no such tag, and its
/// readers refuse or lose such elements beside others with a group. So if there is a group at all,
/// it leaves out points of no group, and curves of no group that only separate regions, as Gmsh
/// does; other curves and surfaces of no group form a group "ungrouped" of their dimension.
/// \param heights  z coordinates, one per vertex; empty: all 0
/// \throw OutputError; InputError  msh22 and an entity in several groups, or a group name with a
///        double quote or a line end, which the format cannot hold
void write_msh(const Mesh& mesh, const std::filesystem::path& path,
               MshFormat format = MshFormat::msh41, std::span<const double> heights = {});

}  // namespace lepp
