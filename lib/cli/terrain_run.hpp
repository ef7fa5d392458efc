#pragma once

#include <optional>
#include <vector>

#include "lepp/io/terrain_report.hpp"
#include "lepp/terrain/simplify.hpp"
#include "lepp/terrain/tile_border.hpp"
#include "lepp/terrain/world_tin.hpp"

namespace lepp::cli {

/// What one grid is to become.
struct TerrainJob {
  SimplifyOptions simplify;
  DomainOptions domain;
  std::optional<double> border_error;  ///< given: the sides of the grid are borders of tiles
  BorderCorners border_corners = {};   ///< of a tile
  bool claims_error = true;            ///< max_error was asked for
  bool nonobtuse = false;
  bool fit_heights = false;
  bool lists_prefixes = false;  ///< the report has the error of each
};

/// A TIN with what was found out about it.
struct MadeTin {
  Tin tin;  ///< in grid space
  WorldTin world;
  TerrainFigures figures;
};

struct MadeTerrain {
  MadeTin finest;
  std::vector<MadeTin> coarser;  ///< the coarsest first
  TerrainReport report;          ///< all but reading and writing
};

/// The grid that another one is a window of, whose georeference counts, and where.
struct GridPlace {
  const HeightGrid& whole;
  std::uint32_t column = 0, row = 0;
};
/// From the grid space of a window to that of the whole.
Point shift_of(const HeightGrid& window, const GridPlace& place);

/// From a grid to TINs that were measured and checked from scratch.
/// \throw Error  as the stages do
MadeTerrain make_terrain(const HeightGrid& grid, const GridPlace& place, const TerrainJob& job);

}  // namespace lepp::cli
