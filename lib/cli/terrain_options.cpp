#include "terrain_options.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "interrupt.hpp"
#include "lepp/io/file_kind.hpp"
#include "lepp/io/terrain_lines.hpp"
#include "validators.hpp"

namespace lepp::cli {

namespace {

std::optional<HeightOrPart> parsed(std::string_view text) {
  HeightOrPart result;
  result.is_percent = text.ends_with('%');
  if (result.is_percent) text.remove_suffix(1);
  const auto value = number_in<double>(text);
  if (!value || !(*value >= 0) || !std::isfinite(*value)) return std::nullopt;
  result.value = *value;
  return result;
}

std::optional<TileCounts> counts_in(std::string_view text) {
  constexpr std::uint32_t most = 10'000;
  const std::size_t x = text.find('x');
  if (x == text.npos) return std::nullopt;
  const auto rows = number_in<std::uint32_t>(text.substr(0, x));
  const auto columns = number_in<std::uint32_t>(text.substr(x + 1));
  if (!rows || !columns || *rows < 1 || *columns < 1 || *rows > most || *columns > most) {
    return std::nullopt;
  }
  return TileCounts{*rows, *columns};
}

void refuse(bool is_wrong, const std::string& option, const std::string& why) {
  if (is_wrong) throw CLI::ValidationError(option, why);
}

void check_format(const TerrainCommand& c) {
  if (c.format.empty()) return;
  const std::string kind = c.format.starts_with("msh") ? ".msh" : ".slf";
  refuse(c.output.target.extension() != kind, "--format",
         c.format + " is of " + kind + " files, and " + c.output.target.string() + " is none");
}

void check_prefixes(const TerrainCommand& c) {
  if (!c.prefix_errors) return;
  refuse(c.json.empty(), "--prefix-errors", "are written to the report only: give --json");
  refuse(c.by == SimplifyBy::lepp, "--prefix-errors",
         "goes with --by greedy only: by lepp vertices come and go between levels, whose errors "
         "are in the report");
  refuse(c.fit_heights, "--prefix-errors", "are of the heights before --fit-heights moves them");
  refuse(c.has_tiles(), "--prefix-errors", "does not go with --tiles");
}

void check_window(const TerrainCommand& c) {
  const auto window = c.grid_window();
  refuse(window && (window->columns < 2 || window->rows < 2), "--window",
         "has no area: give at least two columns and two rows");
  refuse(window && c.border_error.ends_with('%'), "--border-error",
         "would be a percentage of the heights in the window, which its neighbours do not share; "
         "give a height");
}

void check_tiles(const TerrainCommand& c) {
  const bool has_tiles = c.has_tiles();
  refuse(c.tile_output != TileOutput::files && !has_tiles, "--tile-output",
         "goes with --tiles only");
  if (!has_tiles) return;
  refuse(c.max_error.empty(), "--tiles",
         "needs --max-error, by which the borders of tiles are made");
  refuse(c.max_vertices.has_value(), "--max-vertices",
         "is of the whole and cannot go with --tiles");
  refuse(!c.level_vertices.empty(), "--level-vertices",
         "are of the whole and cannot go with --tiles; give --levels");
  refuse(c.nonobtuse, "--nonobtuse", "would cut the borders of tiles");
  refuse(!c.origin.empty(), "--origin", "does not go with --tiles");
  const bool has_lines = !(c.clip.empty() && c.breaklines.empty() && c.soft_breaklines.empty());
  refuse(has_lines, "--tiles",
         "does not go with --clip and --breaklines, which would cut the borders of tiles");
}

}  // namespace

HeightOrPart height_or_part(const std::string& text) {
  return parsed(text).value_or(HeightOrPart());
}

CLI::Validator height_or_percent() {
  return {[](const std::string& text) {
            return parsed(text) ? std::string()
                                : "'" + text + "' does not fit: give a height from 0 on, or a " +
                                      "percentage of the range of heights such as 2%";
          },
          ""};
}

CLI::Validator rows_by_columns() {
  return {[](const std::string& text) {
            return counts_in(text) ? std::string()
                                   : "'" + text + "' does not fit: give ROWSxCOLUMNS such as 4x3";
          },
          ""};
}

HeightGridOptions TerrainCommand::grid_options() const {
  HeightGridOptions options;
  if (cell.size() == 2) options.cell = CellSize{cell[0], cell[1]};
  options.nodata = nodata;
  options.gdal.keep_going = [] { return !interrupted(); };
  return options;
}

std::optional<GridWindow> TerrainCommand::grid_window() const {
  if (window.size() != 4) return std::nullopt;
  return GridWindow{window[0], window[1], window[2], window[3]};
}

TileCounts TerrainCommand::tile_counts() const {
  return tiles.empty() ? TileCounts() : *counts_in(tiles);
}

TinFormat TerrainCommand::tin_format() const {
  TinFormat result;
  if (format == "msh22") result.msh = MshFormat::msh22;
  if (format == "serafin") result.selafin = SelafinPrecision::floats;
  return result;
}

bool TerrainCommand::is_relative() const {
  const auto percent = [](const std::string& text) { return text.ends_with('%'); };
  return percent(max_error) || percent(border_error) || std::ranges::any_of(level_errors, percent);
}

void check_terrain_options(const TerrainCommand& c) {
  refuse(c.max_error.empty() && !c.max_vertices, "--max-error",
         "is missing: give --max-error E, --max-vertices N, or both");
  refuse(!is_tin_file(c.output.target), "--output",
         c.output.target.string() + " is of no kind that holds a TIN; name it " + tin_file_kinds());
  const std::string picture = file_kind(c.picture);
  refuse(!c.picture.empty() && picture != ".svg" && picture != ".png", "--picture",
         c.picture.string() + " is no picture; name it .svg or .png");
  refuse(c.min_angle_deg && c.by == SimplifyBy::greedy, "--min-angle", "goes with --by lepp only");
  refuse(c.effort && c.by == SimplifyBy::greedy, "--effort", "goes with --by lepp only");
  refuse(c.nonobtuse && c.by == SimplifyBy::greedy, "--nonobtuse", "goes with --by lepp only");
  refuse(c.nonobtuse && c.max_vertices, "--nonobtuse",
         "adds vertices beyond any number asked for; give --max-error alone");
  refuse(c.nonobtuse && c.metric == TerrainMetric::surface, "--nonobtuse",
         "goes with --metric planar only");
  refuse(c.nonobtuse && c.asks_for_levels(), "--nonobtuse",
         "moves no vertex but adds some, which levels cannot share; run without levels");
  refuse(c.fit_heights && c.metric == TerrainMetric::surface, "--fit-heights",
         "would bend the surface that --metric surface measures in; it goes with planar only");
  refuse(c.by == SimplifyBy::greedy && c.metric == TerrainMetric::surface, "--metric",
         "surface goes with --by lepp only");
  refuse(!c.border_error.empty() && c.nonobtuse, "--nonobtuse", "would cut the fixed borders");
  check_format(c);
  check_prefixes(c);
  check_window(c);
  check_tiles(c);
}

SimplifyOptions simplify_options(const TerrainCommand& c, double range) {
  SimplifyOptions options;
  if (!c.max_error.empty()) options.max_error = height_or_part(c.max_error).in(range);
  if (c.max_vertices) options.max_vertices = *c.max_vertices;
  options.by = c.by;
  options.metric = c.metric;
  options.min_angle_deg = c.min_angle_deg.value_or(options.min_angle_deg);
  options.effort = c.effort.value_or(options.effort);
  for (const std::string& text : c.level_errors) {
    options.level_errors.push_back(height_or_part(text).in(range));
  }
  options.level_vertices = c.level_vertices;
  const auto& errors = options.level_errors;
  const double last = options.max_error;  // on flat ground 0, as all percentages
  refuse(!std::ranges::is_sorted(errors, std::greater<>()) ||
             (!errors.empty() && last > 0 && errors.back() <= last),
         "--levels", "must be errors that descend, all above --max-error");
  const auto& counts = options.level_vertices;
  refuse(
      !std::ranges::is_sorted(counts) || (!counts.empty() && counts.back() >= options.max_vertices),
      "--level-vertices", "must be counts that ascend, all below --max-vertices");
  return options;
}

DomainOptions domain_options(const TerrainCommand& c, const HeightGrid& grid,
                             std::vector<std::string>& warnings) {
  TerrainLineOptions options;
  options.grid_crs = grid.crs;
  options.warnings = &warnings;
  DomainOptions domain;
  for (const auto& file : c.clip) {
    for (ClipPolygon& p : read_clip_polygons(file, options)) domain.clip.push_back(std::move(p));
  }
  const auto add = [&](const std::filesystem::path& file) {
    for (Breakline& l : read_breaklines(file, options)) domain.breaklines.push_back(std::move(l));
  };
  for (const auto& file : c.breaklines) add(file);
  options.ignore_heights = true;
  for (const auto& file : c.soft_breaklines) add(file);
  return domain;
}

std::optional<double> border_error(const TerrainCommand& c, double range) {
  if (c.border_error.empty() && !c.has_tiles()) return std::nullopt;
  const double whole = height_or_part(c.max_error).in(range);
  if (c.border_error.empty()) return whole;
  const double error = height_or_part(c.border_error).in(range);
  refuse(!c.max_error.empty() && error > whole, "--border-error",
         "is above --max-error, which borders have to keep too");
  return error;
}

}  // namespace lepp::cli
