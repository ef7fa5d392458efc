// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "lepp/io/gmsh_record.hpp"

namespace lepp::gmsh_helper {

/// Fills GmshRecord::largest_size, and inner_sizes for points that are embedded in surfaces.
///
/// The SDK does not tell the size of a point, but a copy of a point has it: on a straight curve
/// between the two Gmsh puts points at that distance. To be called last: it spoils the model. Sizes
/// of points that another kernel than Gmsh's own made stay unknown, with a warning.
void add_inner_sizes(GmshRecord& record);

}  // namespace lepp::gmsh_helper
