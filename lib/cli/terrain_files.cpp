#include "terrain_files.hpp"

#include <array>
#include <set>

#include "lepp/geometry/error.hpp"
#include "lepp/io/file_kind.hpp"

namespace lepp::cli {

namespace {

namespace fs = std::filesystem;

// What stands beside a raster or a vector file and is read with it.
constexpr std::array beside = {".prj", ".hdr", ".aux", ".tfw", ".wld", ".ovr", ".msk",
                               ".shx", ".dbf", ".cpg", ".qpj", ".sbn", ".sbx", ".qix"};
constexpr std::array behind = {".aux.xml", ".ovr", ".msk", ".prj"};

// GDAL takes the coordinate system of a GeoTIFF from itself, not from a .prj beside it.
bool knows_its_crs(const fs::path& input, const HeightGrid& grid) {
  const std::string kind = file_kind(input);
  return (kind == ".tif" || kind == ".tiff") && !grid.crs.empty();
}

// grid: its header, or nothing if it is not read yet
Files inputs_of(const TerrainCommand& command, const HeightGrid& grid) {
  Files named{command.input};
  for (const auto* more : {&command.clip, &command.breaklines, &command.soft_breaklines}) {
    named.insert(named.end(), more->begin(), more->end());
  }
  Files files;
  std::error_code error;
  const auto add = [&](const fs::path& file) {
    if (fs::exists(file, error)) files.push_back(file);
  };
  for (const fs::path& file : named) {
    add(file);
    for (const char* extension : beside) {
      const bool is_read = extension != std::string_view(".prj") || &file != &named.front() ||
                           !knows_its_crs(file, grid);
      if (is_read) add(fs::path(file).replace_extension(extension));
    }
    for (const char* more : behind) add(fs::path(file).concat(more));
  }
  return files;
}

// Of all TINs that a run writes.
std::vector<std::string> suffixes_of(const TerrainCommand& command) {
  std::vector<std::string> suffixes;
  const auto add = [&](const std::string& of) {
    for (std::size_t i = 1; i <= command.coarser_levels(); ++i) {
      suffixes.push_back(of + level_suffix(i));
    }
    suffixes.push_back(of);
  };
  const TileCounts tiles = command.tile_counts();
  for (std::uint32_t row = 0; command.writes_tiles() && row < tiles.rows; ++row) {
    for (std::uint32_t column = 0; column < tiles.columns; ++column) add(tile_suffix(row, column));
  }
  if (command.writes_whole()) add("");
  return suffixes;
}

Files targets_of(const TerrainCommand& command, bool has_crs) {
  Files targets;
  for (const std::string& suffix : suffixes_of(command)) {
    const Files tin = tin_files_of(with_suffix(command.output.target, suffix), has_crs);
    targets.insert(targets.end(), tin.begin(), tin.end());
    if (!command.picture.empty()) targets.push_back(with_suffix(command.picture, suffix));
  }
  return targets;
}

// The same for all names of a file.
fs::path place_of(const fs::path& file) {
  std::error_code error;
  return fs::weakly_canonical(fs::absolute(file), error);
}

std::set<fs::path> places_of(const std::vector<std::string>& files) {
  std::set<fs::path> places;
  for (const std::string& file : files) places.insert(place_of(file));
  return places;
}

void refuse_part(const fs::path& target, const std::set<fs::path>& parts) {
  if (!parts.contains(place_of(target))) return;
  throw OutputError(target.string(), "is also a part of the input", "choose another name");
}

void refuse_the_same_twice(const Files& targets) {
  std::set<fs::path> seen;
  for (const fs::path& target : targets) {
    if (seen.insert(place_of(target)).second) continue;
    throw OutputError(target.string(), "is named for two outputs", "choose another name");
  }
}

}  // namespace

fs::path with_suffix(const fs::path& path, const std::string& suffix) {
  return path.parent_path() / (path.stem().string() + suffix + path.extension().string());
}

std::string level_suffix(std::size_t level) { return ".level" + std::to_string(level); }

std::string tile_suffix(std::uint32_t row, std::uint32_t column) {
  return "_" + std::to_string(row) + "_" + std::to_string(column);
}

void check_terrain_files(const TerrainCommand& command, const HeightGrid& grid) {
  const Files inputs = inputs_of(command, grid);
  const Files targets = targets_of(command, !grid.crs.empty());
  const std::set<fs::path> parts = places_of(grid.files);
  for (const fs::path& target : targets) {
    if (is_prj_of(target, grid.crs)) continue;
    check_target(target, inputs, command.output.force);
    refuse_part(target, parts);
  }
  refuse_the_same_twice(targets);
  check_report_target(command.json, inputs, targets);
  if (!command.json.empty() && command.json != "-") refuse_part(command.json, parts);
}

void warn_of_old_prj(const TerrainCommand& command, const HeightGrid& grid,
                     std::vector<std::string>& warnings) {
  if (!grid.crs.empty()) return;
  for (const fs::path& target : targets_of(command, true)) {
    std::error_code error;
    if (target.extension() != ".prj" || !fs::is_regular_file(target, error)) continue;
    warnings.push_back(target.string() +
                       " stands beside a mesh without a coordinate reference system, and programs "
                       "will take it for the mesh's: remove it if it is not");
  }
}

void write_level(MadeTin& made, HillshadeOptions picture, const TerrainCommand& command,
                 const std::string& suffix) {
  const fs::path target = with_suffix(command.output.target, suffix);
  write_tin(made.world, target, command.tin_format());
  made.figures.output = target.string();
  if (command.picture.empty()) return;
  picture.width = command.picture_width;
  write_hillshade(made.tin, with_suffix(command.picture, suffix), picture);
}

}  // namespace lepp::cli
