// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "lepp/io/gmsh_record.hpp"

namespace lepp::gmsh_helper {

/// Nodes, triangles, lines and points of the open .msh file, with the entities they belong to and
/// the groups of those. A part of a partitioned entity counts as the entity itself.
/// \throw GmshFailure  naming elements of other kinds
void add_mesh(GmshRecord& record);

}  // namespace lepp::gmsh_helper
