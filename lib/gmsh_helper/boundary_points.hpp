// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "lepp/io/gmsh_record.hpp"

namespace lepp::gmsh_helper {

/// Fills GmshCurve::inner with the points that Gmsh puts on each curve (generate(1)).
///
/// The number is predicted first, from runs with all sizes multiplied by 1e12, 1e9, ...: where that
/// leaves enough points to count, their number grows as the factor falls.
/// \throw GmshFailure  more than a million points
void add_own_points(GmshRecord& record);

}  // namespace lepp::gmsh_helper
