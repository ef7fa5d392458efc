#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <new>

#include "commands.hpp"
#include "interrupt.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/geometry/text.hpp"
#include "stopwatch.hpp"
#include "terrain_arguments.hpp"
#include "terrain_files.hpp"
#include "terrain_piece.hpp"
#include "terrain_reports.hpp"
#include "terrain_run.hpp"
#include "terrain_tiles.hpp"

namespace lepp::cli {

namespace {

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

void write_all(MadeTerrain& made, const HeightGrid& grid, const TerrainCommand& command) {
  HillshadeOptions picture;
  picture.cell_width = grid.cell_width;
  for (std::size_t i = 0; i < made.coarser.size(); ++i) {
    write_level(made.coarser[i], picture, command, level_suffix(i + 1));
    made.report.levels[i].output = made.coarser[i].figures.output;
  }
  write_level(made.finest, picture, command, "");
  warn_of_floats(made.finest.world, grid, command, made.report.warnings);
  made.report.whole.output = made.finest.figures.output;
}

void warn_of_left_samples(const Piece& piece, std::vector<std::string>& warnings) {
  const std::size_t count = piece.left_to_neighbours;
  if (count == 0) return;
  warnings.push_back(std::to_string(count) + (count == 1 ? " sample" : " samples") +
                     " on the border of the window " + (count == 1 ? "is" : "are") +
                     " left to the windows beside it: no cell of this one covers " +
                     (count == 1 ? "it" : "them"));
}

int run_whole(const TerrainCommand& command, TerrainReport& report) {
  const auto start = Clock::now();
  check_terrain_files(command);
  Piece piece = read_piece(command);
  std::vector<std::string> warnings = piece.place().whole.warnings;
  warn_of_units(command, piece.grid, warnings);
  warn_of_left_samples(piece, warnings);
  warn_of_cell(command, piece.place().whole, warnings);
  TerrainJob job = job_of(command, piece, warnings);
  if (command.origin.size() == 2) {
    count_from_origin({command.origin[0], command.origin[1]}, piece, job.domain, warnings);
  }
  check_terrain_files(command, piece.place().whole);
  warn_of_old_prj(command, piece.place().whole, warnings);
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

// The report of tiles that were to be made before an error; the error is what counts, whatever
// becomes of the report.
void print_what_there_is(const TerrainCommand& command, TerrainReport& report,
                         Clock::time_point start) {
  try {
    if (report.tiling) print(command, report, start);
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
  } catch (const std::bad_alloc&) {
    print_what_there_is(command, report, start);
    throw RefusedError(command.input.string(), "there is not enough memory for it",
                       command.has_tiles() ? "ask for more and smaller --tiles"
                                           : "read it in parts, with --tiles ROWSxCOLUMNS");
  } catch (const std::exception&) {
    print_what_there_is(command, report, start);
    throw;
  }
  const std::string words = last_words(status, command, report);
  warn_of_small_angles(report);
  if (!words.empty()) report.warnings.push_back(words);
  if (command.quiet && status != done && !report.warnings.empty()) {
    std::fprintf(stderr, "lepp: %s: %s\n", command.input.c_str(), report.warnings.back().c_str());
  }
  print(command, report, start);
  return status;
}

}  // namespace

void add_terrain_command(CLI::App& app, int& status) {
  const auto command = std::make_shared<TerrainCommand>();
  CLI::App& terrain =
      *app.add_subcommand("terrain", "Make a TIN of a height grid (DEM) within an error bound");
  add_terrain_arguments(terrain, *command);
  terrain.callback([command, &status] { status = run(*command); });
}

}  // namespace lepp::cli
