#pragma once

#include "lepp/triangulation/constrained_delaunay.hpp"

namespace lepp::plain {

/// What lepp::constrained_delaunay() promises with Crossings::refuse, the slow and simple way.
/// \throw InputError as there
Triangulation constrained_delaunay(const Pslg& pslg);

}  // namespace lepp::plain
