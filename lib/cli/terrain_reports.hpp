#pragma once

#include "lepp/io/terrain_report.hpp"
#include "terrain_options.hpp"
#include "terrain_run.hpp"

namespace lepp::cli {

/// Adds what was found for a tile to the report of the whole.
void add_to(TerrainReport& whole, const TerrainReport& part);

/// Warns of levels with triangles below the bound which neither the input nor a fixed border
/// excuses.
void warn_of_small_angles(TerrainReport& report);

/// Warns if the cells of --cell have other proportions than those of the file, which its
/// coordinates keep.
void warn_of_cell(const TerrainCommand& command, const HeightGrid& whole,
                  std::vector<std::string>& warnings);

/// Fills in what a report says of a grid: size, samples, range of heights.
void describe(const HeightGrid& grid, TerrainReport& report);
/// Fills in what it says was asked for, but for errors, which may be percentages.
void describe(const TerrainCommand& command, TerrainReport& report);
/// Fills in all of it.
void describe(const TerrainCommand& command, const TerrainJob& job, TerrainReport& report);

}  // namespace lepp::cli
