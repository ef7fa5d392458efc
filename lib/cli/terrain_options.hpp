#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lepp/io/height_grid_read.hpp"
#include "lepp/io/tin_files.hpp"
#include "lepp/terrain/simplify.hpp"
#include "lepp/terrain/terrain_domain.hpp"
#include "outputs.hpp"

namespace lepp::cli {

/// A height, or a part of the range of all heights: "2.5", "2%".
struct HeightOrPart {
  double value = 0;
  bool is_percent = false;

  double in(double range) const { return is_percent ? value / 100 * range : value; }
};
HeightOrPart height_or_part(const std::string& text);

struct TileCounts {
  std::uint32_t rows = 1, columns = 1;
};

enum class TileOutput { files, mesh, both };

/// The command line of `lepp terrain`.
struct TerrainCommand {
  std::filesystem::path input;
  OutputOptions output;
  std::string format;                   ///< empty: the usual one of the output's kind
  std::string max_error, border_error;  ///< as typed; empty: not given
  std::vector<std::string> level_errors;
  std::vector<std::size_t> level_vertices;
  std::optional<std::size_t> max_vertices;
  SimplifyBy by = SimplifyBy::lepp;
  TerrainMetric metric = TerrainMetric::planar;
  std::optional<double> min_angle_deg;
  std::optional<Effort> effort;
  std::vector<double> cell;  ///< none or two
  std::optional<double> nodata;
  std::vector<double> origin;  ///< none or two
  std::vector<std::filesystem::path> clip, breaklines, soft_breaklines;
  std::vector<std::uint32_t> window;  ///< none, or column, row, width and height
  std::string tiles;
  TileOutput tile_output = TileOutput::files;
  std::filesystem::path picture;
  double picture_width = 1000;
  std::string json;
  bool nonobtuse = false, fit_heights = false, prefix_errors = false;
  bool allow_unfinished = false, quiet = false;

  HeightGridOptions grid_options() const;
  std::optional<GridWindow> grid_window() const;
  TileCounts tile_counts() const;
  bool has_tiles() const { return !tiles.empty(); }
  bool writes_tiles() const { return has_tiles() && tile_output != TileOutput::mesh; }
  bool writes_whole() const { return !has_tiles() || tile_output != TileOutput::files; }
  TinFormat tin_format() const;
  bool asks_for_levels() const { return !level_errors.empty() || !level_vertices.empty(); }
  bool is_relative() const;  ///< some error is given in percent
  std::size_t coarser_levels() const { return level_errors.size() + level_vertices.size(); }
};

/// Validators of what they name.
CLI::Validator height_or_percent();
CLI::Validator rows_by_columns();

/// \throw CLI::ValidationError  options that do not go together
void check_terrain_options(const TerrainCommand& command);

/// What the core is asked for. \param range  of the heights of the grid
SimplifyOptions simplify_options(const TerrainCommand& command, double range);
/// Reads clip polygons and breaklines, in the world coordinates of the file.
DomainOptions domain_options(const TerrainCommand& command, const HeightGrid& grid,
                             std::vector<std::string>& warnings);
/// The error of borders, if they are to be fixed.
std::optional<double> border_error(const TerrainCommand& command, double range);

}  // namespace lepp::cli
