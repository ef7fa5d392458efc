// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "lepp/io/gmsh_record.hpp"

namespace lepp::gmsh_helper {

/// Physical groups of every dimension, with names.
void add_groups(GmshRecord& record);

/// Tags of the physical groups of one entity, smallest first, without sign.
std::vector<int> groups_of(int dimension, int tag);

/// Points, curves and surfaces of the open geometry.
/// \throw GmshFailure  an entity without geometry (a mesh that the file merges)
void add_geometry(GmshRecord& record);

}  // namespace lepp::gmsh_helper
