#pragma once

#include <optional>

#include "lepp/terrain/height_grid.hpp"

namespace lepp {

/// Width and height of a cell, > 0.
struct CellSize {
  double width = 1, height = 1;
};

/// Gives a grid that was read its cell size: the one given, or what its georeference says; and
/// where it has none, a georeference of that cell size.
/// \throw InputError  coordinates that cannot hold a mesh of the samples: not finite, without the
///                    digits to tell samples well apart, out of the range of the predicates; cells
///                    too long for their width
void place_grid(const std::optional<CellSize>& cell, HeightGrid& grid);

}  // namespace lepp
