#pragma once

#include "terrain_options.hpp"

namespace lepp::cli {

/// The arguments of `lepp terrain`, and what its --help says of them.
void add_terrain_arguments(CLI::App& app, TerrainCommand& command);

}  // namespace lepp::cli
