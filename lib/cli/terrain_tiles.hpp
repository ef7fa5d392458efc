#pragma once

#include "terrain_options.hpp"
#include "terrain_run.hpp"

namespace lepp::cli {

/// Makes the tiles of a raster one by one, each from its own window of the file, and writes each as
/// it is ready. Neighbours share a line of samples, and the vertices on it.
/// \return  the exit status
int run_tiles(const TerrainCommand& command, TerrainReport& report);

}  // namespace lepp::cli
