#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "lepp/io/hillshade.hpp"
#include "terrain_options.hpp"
#include "terrain_run.hpp"

namespace lepp::cli {

/// dir/name.ext becomes dir/name<suffix>.ext.
std::filesystem::path with_suffix(const std::filesystem::path& path, const std::string& suffix);
std::string level_suffix(std::size_t level);  ///< ".level1" for the coarsest
std::string tile_suffix(std::uint32_t row, std::uint32_t column);

/// Asked before anything is written: no file that a run writes, the report and .prj files included,
/// is one that it reads or another one that it writes, and none exists but with --force. A .prj
/// that says the same already is left as it is, and may be the grid's own.
/// \param grid  its header, or nothing if it is not read yet
/// \throw OutputError
void check_terrain_files(const TerrainCommand& command, const HeightGrid& grid = {});

/// Warns of each .prj beside a TIN that gets none: of an earlier run, or the grid's own where
/// coordinates count from another origin.
/// \param grid  what is written has its coordinate reference system
void warn_of_old_prj(const TerrainCommand& command, const HeightGrid& grid,
                     std::vector<std::string>& warnings);

/// Writes a TIN, and its picture if one is asked for.
/// \param picture  how it is drawn, but for the width
void write_level(MadeTin& made, HillshadeOptions picture, const TerrainCommand& command,
                 const std::string& suffix);

}  // namespace lepp::cli
