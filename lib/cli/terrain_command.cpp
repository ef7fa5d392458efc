#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>

#include "commands.hpp"
#include "interrupt.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/io/raster_layout.hpp"
#include "terrain_files.hpp"
#include "terrain_options.hpp"
#include "terrain_reports.hpp"
#include "terrain_run.hpp"
#include "terrain_tiles.hpp"
#include "validators.hpp"

namespace lepp::cli {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Files of 32-bit coordinates leave few digits within a cell where the grid is large.
void warn_of_floats(const WorldTin& tin, const HeightGrid& grid, const TerrainCommand& command,
                    std::vector<std::string>& warnings) {
  constexpr double noticeable = 1e-4;  // of a cell
  const auto digits = offset_of_format(command.output.target, command.tin_format());
  if (!digits) return;
  const double moved = rounding_of_float_file(tin, *digits);
  const double of_cell = moved / std::min(grid.step_x, std::abs(grid.step_y));
  if (of_cell <= noticeable) return;
  warnings.push_back(
      "the coordinates of the file are 32-bit numbers, which moves vertices by up to " +
      lepp::to_text(moved) + ", " + lepp::to_text(float(of_cell)) +
      " of a cell; what was measured is the TIN before");
}

int status_of(const TerrainReport& report) {
  if (!report.valid) return bug;
  if (interrupted()) return refused;
  return report.goal_reached ? done : unfinished;
}

// What is meshed in one piece: a grid, or a window of one.
struct Piece {
  std::optional<HeightGrid> whole;  // without heights, where `grid` is a window of it
  GridWindow window;
  HeightGrid grid;
  BorderCorners corners;

  GridPlace place() const {
    return whole ? GridPlace{*whole, window.column, window.row} : GridPlace{grid};
  }
};

Piece read_piece(const TerrainCommand& command) {
  Piece piece;
  const auto window = command.grid_window();
  if (!window) {
    piece.grid = read_height_grid(command.input, command.grid_options());
    return piece;
  }
  piece.whole = read_height_grid_header(command.input, command.grid_options());
  piece.window = *window;
  grid_of_window(*piece.whole, *window);  // throws if it sticks out
  if (command.border_error.empty()) {
    piece.grid = read_height_window(command.input, *window, command.grid_options());
  } else {  // as a tile: neighbours are windows too
    GridPart part = read_grid_part(command.input, *piece.whole, *window, command.grid_options());
    piece.corners = border_corners(part);
    leave_to_neighbours(part);
    piece.grid = std::move(part.grid);
  }
  check_usable(piece.grid);
  return piece;
}

TerrainJob job_of(const TerrainCommand& command, const Piece& piece,
                  std::vector<std::string>& warnings) {
  TerrainReport found;
  describe(piece.grid, found);
  const double range = found.highest - found.lowest;
  TerrainJob job;
  job.simplify = simplify_options(command, range);
  job.border_error = border_error(command, range);
  job.border_corners = piece.corners;
  job.domain = domain_options(command, piece.grid, warnings);
  job.domain.islands_stay_inside = job.border_error && !piece.whole;
  job.claims_error = !command.max_error.empty();
  job.nonobtuse = command.nonobtuse;
  job.fit_heights = command.fit_heights;
  return job;
}

// Lines are read before, in the coordinates of the file.
void count_from_origin(Point origin, Piece& piece, DomainOptions& domain,
                       std::vector<std::string>& warnings) {
  const bool had_crs = !piece.grid.crs.empty();
  lepp::count_from(origin, piece.grid);
  if (piece.whole) lepp::count_from(origin, *piece.whole);
  for (Breakline& line : domain.breaklines) {
    for (Point& p : line.points) p = p - origin;
  }
  for (ClipPolygon& polygon : domain.clip) {
    for (std::vector<Point>& ring : polygon.rings) {
      for (Point& p : ring) p = p - origin;
    }
  }
  if (!had_crs) return;
  warnings.push_back("coordinates count from " + lepp::to_text(origin) +
                     ", so the coordinate reference system is not written");
}

void write_all(MadeTerrain& made, const HeightGrid& grid, const TerrainCommand& command) {
  for (std::size_t i = 0; i < made.coarser.size(); ++i) {
    write_level(made.coarser[i], grid.cell_width, command, level_suffix(i + 1));
    made.report.levels[i].output = made.coarser[i].figures.output;
  }
  write_level(made.finest, grid.cell_width, command, "");
  warn_of_floats(made.finest.world, grid, command, made.report.warnings);
  made.report.whole.output = made.finest.figures.output;
}

int run_whole(const TerrainCommand& command, TerrainReport& report) {
  const auto start = Clock::now();
  check_terrain_files(command);
  Piece piece = read_piece(command);
  std::vector<std::string> warnings = piece.place().whole.warnings;
  TerrainJob job = job_of(command, piece, warnings);
  if (command.origin.size() == 2) {
    count_from_origin({command.origin[0], command.origin[1]}, piece, job.domain, warnings);
  }
  check_terrain_files(command, piece.place().whole);
  const double reading = seconds_since(start);
  MadeTerrain made = make_terrain(piece.grid, piece.place(), job);
  const int status = status_of(made.report);
  if (status == done || (status == unfinished && command.allow_unfinished)) {
    const auto writing = Clock::now();
    write_all(made, piece.grid, command);
    made.report.seconds.write = seconds_since(writing);
  }
  report = std::move(made.report);
  report.seconds.read = reading;
  report.warnings.insert(report.warnings.begin(), warnings.begin(), warnings.end());
  describe(command, job, report);
  return status;
}

void print(const TerrainCommand& command, TerrainReport& report, Clock::time_point start) {
  for (std::size_t i = 0; i < report.levels.size(); ++i) {
    report.levels[i].name = "level " + std::to_string(i + 1);
  }
  report.input = command.input.string();
  report.seconds.total = seconds_since(start);
  report.peak_memory_bytes = peak_memory_bytes();
  print_report(to_text(report), to_json(report), command.json, command.quiet);
}

// The report of tiles that were made before an error; the error is what counts, whatever becomes of
// the report.
void print_what_there_is(const TerrainCommand& command, TerrainReport& report,
                         Clock::time_point start) {
  try {
    if (!report.tiles.empty()) print(command, report, start);
  } catch (const Error&) {
  }
}

std::string last_words(int status, const TerrainCommand& command, const TerrainReport& report) {
  const bool some_stay = std::ranges::any_of(
      report.tiles, [](const TerrainFigures& tile) { return !tile.output.empty(); });
  const std::string stay = some_stay ? "; the tiles that are done stay" : "";
  if (status == refused) return "cancelled; nothing more was written" + stay;
  if (status != unfinished || command.allow_unfinished) return {};
  return "the goal was not reached, so nothing more was written; "
         "--allow-unfinished writes the valid TIN all the same" +
         stay;
}

int run(const TerrainCommand& command) {
  const auto start = Clock::now();
  check_terrain_options(command);
  TerrainReport report;
  int status = done;
  try {
    status = command.has_tiles() ? run_tiles(command, report) : run_whole(command, report);
  } catch (const std::exception&) {
    print_what_there_is(command, report, start);
    throw;
  }
  const std::string words = last_words(status, command, report);
  if (!words.empty()) report.warnings.push_back(words);
  if (command.quiet && status != done && !report.warnings.empty()) {
    std::fprintf(stderr, "lepp: %s: %s\n", command.input.c_str(), report.warnings.back().c_str());
  }
  print(command, report, start);
  return status;
}

void add_goals(CLI::App& app, TerrainCommand& command) {
  app.add_option(
         "--max-error", command.max_error,
         "largest difference from any sample, in the unit of heights, or of their range: 2%")
      ->check(height_or_percent());
  app.add_option("--max-vertices", command.max_vertices, "no more vertices than this")
      ->check(whole_number_from(3));
  app.add_option("--by", command.by,
                 "lepp: angles are bounded; greedy: fewest vertices (default lepp)")
      ->transform(
          choice_of<SimplifyBy>({{"lepp", SimplifyBy::lepp}, {"greedy", SimplifyBy::greedy}}));
  app.add_option("--min-angle", command.min_angle_deg,
                 "smallest angle wanted, by lepp (default 30)")
      ->check(number_from(0, 34));
  app.add_option("--effort", command.effort,
                 "fast, normal or best: time spent on fewer vertices, by lepp (default normal)")
      ->transform(choice_of<Effort>(
          {{"fast", Effort::fast}, {"normal", Effort::normal}, {"best", Effort::best}}));
  app.add_option("--metric", command.metric,
                 "planar: lengths and angles of the map; surface: those in space (default planar)")
      ->transform(choice_of<TerrainMetric>(
          {{"planar", TerrainMetric::planar}, {"surface", TerrainMetric::surface}}));
  app.add_option("--levels", command.level_errors,
                 "errors of coarser levels, descending: 10%,5% or 50,20; level i is written as "
                 "NAME.level<i>.EXT, the coarsest being 1")
      ->delimiter(',')
      ->check(height_or_percent());
  app.add_option("--level-vertices", command.level_vertices,
                 "numbers of vertices of coarser levels, ascending")
      ->delimiter(',')
      ->check(whole_number_from(3));
  app.add_flag(
      "--fit-heights", command.fit_heights,
      "Move the heights of vertices, within the bound, to where the root mean square of the "
      "error is least");
  app.add_flag("--nonobtuse", command.nonobtuse,
               "leave no obtuse angle opposite an edge of the outline, so that the Voronoi boxes "
               "are admissible for finite volumes");
}

void add_inputs(CLI::App& app, TerrainCommand& command) {
  app.add_option("--cell", command.cell,
                 "width and height of a cell, where the file does not say or is wrong")
      ->expected(2)
      ->check(number_above_zero());
  app.add_option("--nodata", command.nodata,
                 "value of the file, before scale and offset, that means no data");
  app.add_option(
         "--origin", command.origin,
         "X Y: subtracted from all coordinates that are written or reported, for cells that "
         "are small beside them")
      ->expected(2)
      ->check(finite_number());
  app.add_option("--clip", command.clip,
                 "polygons outside of which nothing is meshed: GeoJSON, or what GDAL reads; may be "
                 "given again");
  app.add_option("--breaklines", command.breaklines,
                 "lines kept as edges, with the heights of the file if it has any, else with those "
                 "of the grid; may be given again");
  app.add_option("--soft-breaklines", command.soft_breaklines,
                 "the same, always with the heights of the grid");
}

void add_tiles(CLI::App& app, TerrainCommand& command) {
  app.add_option("--window", command.window,
                 "COLUMN ROW WIDTH HEIGHT in samples, row 0 the first of the file: nothing else is "
                 "read and meshed")
      ->expected(4)
      ->check(whole_number_from(0));
  app.add_option(
         "--tiles", command.tiles,
         "ROWSxCOLUMNS: the raster is read and meshed piece by piece; tile (row, column) is "
         "written as NAME_<row>_<column>.EXT, row 0 the first of the file")
      ->check(rows_by_columns());
  app.add_option("--tile-output", command.tile_output,
                 "files: one per tile; mesh: all tiles joined in one; both (default files)")
      ->transform(choice_of<TileOutput>(
          {{"files", TileOutput::files}, {"mesh", TileOutput::mesh}, {"both", TileOutput::both}}));
  app.add_option("--border-error", command.border_error,
                 "vertices on the sides of the raster depend on nothing but the samples there and "
                 "this error, so that neighbours match (with --tiles: of each tile, default "
                 "--max-error; with --window: of the window)")
      ->check(height_or_percent());
}

void add_outputs(CLI::App& app, TerrainCommand& command) {
  app.add_option("--picture", command.picture, "hill-shaded picture, .svg or .png; one per level");
  app.add_option("--picture-width", command.picture_width, "its longest side")
      ->check(number_from(1, 20'000))
      ->capture_default_str();
  app.add_option("--json", command.json, "write the report as JSON to a file, or - for stdout");
  app.add_option("--format", command.output.format,
                 "of .msh: msh41 (default) or msh22; of .slf: serafind (default) or serafin, of "
                 "single precision")
      ->check(CLI::IsMember({"msh41", "msh22", "serafind", "serafin"}));
  app.add_flag("--allow-unfinished", command.allow_unfinished,
               "write a valid TIN even if the goal was not reached (status 3)");
  app.add_flag("--force", command.output.force, "overwrite outputs");
  app.add_flag("-q,--quiet", command.quiet, "no report on the terminal");
}

}  // namespace

void add_terrain_command(CLI::App& app, int& status) {
  const auto command = std::make_shared<TerrainCommand>();
  CLI::App& terrain =
      *app.add_subcommand("terrain", "Make a TIN of a height grid (DEM) within an error bound");
  terrain
      .add_option("DEM", command->input,
                  ".asc, .stm, .pgm, .npy, .f32, or what GDAL reads: .tif, ...")
      ->required();
  terrain.add_option("-o,--output", command->output.target, tin_file_kinds())->required();
  add_goals(terrain, *command);
  add_inputs(terrain, *command);
  add_tiles(terrain, *command);
  add_outputs(terrain, *command);
  terrain.footer(
      "Examples:\n"
      "  lepp terrain dem.tif -o dem.ply --max-error 2\n"
      "  lepp terrain dem.asc -o fort.14 --max-error 1% --picture dem.png --json report.json\n"
      "  lepp terrain dem.stm -o dem.obj --cell 30 30 --max-error 5 --levels 100,30 --by greedy\n"
      "  lepp terrain dem.tif -o valley.nc --max-error 1 --clip valley.geojson --breaklines "
      "rivers.shp\n"
      "  lepp terrain catchment.asc -o catchment.msh --max-error 1 --nonobtuse\n"
      "  lepp terrain large.f32 -o large.2dm --max-error 2 --tiles 4x4");
  terrain.callback([command, &status] { status = run(*command); });
}

}  // namespace lepp::cli
