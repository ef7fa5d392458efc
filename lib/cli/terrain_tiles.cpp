#include "terrain_tiles.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

#include "commands.hpp"
#include "interrupt.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/io/raster_layout.hpp"
#include "lepp/terrain/join_tins.hpp"
#include "lepp/triangulation/validate.hpp"
#include "stopwatch.hpp"
#include "terrain_files.hpp"
#include "terrain_piece.hpp"
#include "terrain_reports.hpp"

namespace lepp::cli {

namespace {

// Where a part of n samples begins, of so many parts that share their ends.
std::uint32_t begin_of(std::uint32_t part, std::uint32_t parts, std::uint32_t n) {
  return static_cast<std::uint32_t>(std::uint64_t{part} * (n - 1) / parts);
}

GridWindow tile_window(const GridWindow& region, const TileCounts& tiles, std::uint32_t row,
                       std::uint32_t column) {
  const std::uint32_t north = begin_of(row, tiles.rows, region.rows);
  const std::uint32_t west = begin_of(column, tiles.columns, region.columns);
  return {region.column + west, region.row + north,
          begin_of(column + 1, tiles.columns, region.columns) - west + 1,
          begin_of(row + 1, tiles.rows, region.rows) - north + 1};
}

// What an error says, in one line.
std::string one_line(const std::exception& error) {
  const auto* const ours = dynamic_cast<const Error*>(&error);
  return ours == nullptr ? error.what() : ours->where() + ": " + ours->problem();
}

class Tiles {
 public:
  Tiles(const TerrainCommand& command, TerrainReport& report)
      : command_(command),
        report_(report),
        counts_(command.tile_counts()),
        file_(command.input, command.grid_options()),
        whole_(file_.whole()),
        region_(command.grid_window().value_or(GridWindow{0, 0, whole_.columns, whole_.rows})) {
    check_counts();
    check_terrain_files(command, whole_);
    report_.valid = true;
    report_.columns = region_.columns;
    report_.rows = region_.rows;
    report_.warnings = whole_.warnings;
    warn_of_old_prj(command, whole_, report_.warnings);
    warn_of_units(command, whole_, report_.warnings);
    warn_of_cell(command, whole_, report_.warnings);
  }

  int run() { return decide_bounds() ? make_tiles() : stopped(refused); }

 private:
  void check_counts() const {
    grid_of_window(whole_, region_);  // throws if it sticks out
    if (counts_.rows < region_.rows && counts_.columns < region_.columns) return;
    throw InputError(command_.input.string() + ", --tiles " + command_.tiles,
                     "asks for more tiles than the " + std::to_string(region_.rows) + " x " +
                         std::to_string(region_.columns) + " samples have cells",
                     "give fewer rows and columns of tiles");
  }

  // All tiles keep the same bounds: percentages are of the range of all heights, and so are the
  // colours of pictures.
  // Returns false if the user does not want to wait for it.
  bool decide_bounds() {
    const auto start = Clock::now();
    const bool needs_range = command_.is_relative() || !command_.picture.empty();
    if (needs_range && !try_to_find_range()) return false;
    report_.seconds.read += seconds_since(start);
    const double range = lowest_ <= highest_ ? highest_ - lowest_ : 0;
    job_.simplify = simplify_options(command_, range);
    job_.border_error = border_error(command_, range);
    job_.fit_heights = command_.fit_heights;
    describe(command_, job_, report_);
    note_range();
    picture_.cell_width = whole_.cell_width;
    if (lowest_ <= highest_) picture_.heights = {lowest_, highest_};
    return true;
  }

  bool try_to_find_range() {
    try {
      return find_range();
    } catch (const std::exception& error) {
      describe(command_, report_);
      report_.error_kept = false;
      report_.warnings.push_back("no tile was begun: " + one_line(error));
      throw;
    }
  }

  // Where bounds go by it, it is that of all heights, whatever tiles are left out or not reached.
  void note_range() {
    if (!(lowest_ <= highest_)) return;
    report_.lowest = lowest_;
    report_.highest = highest_;
  }

  // A pass over the file.
  bool find_range() {
    for (const GridWindow& band : bands_of(region_)) {
      if (interrupted()) return false;
      TerrainReport part;
      describe(file_.read(band), part);
      if (part.samples == 0) continue;
      lowest_ = std::min(lowest_, part.lowest);
      highest_ = std::max(highest_, part.highest);
    }
    return true;
  }

  int make_tiles() {
    for (std::uint32_t row = 0; row < counts_.rows; ++row) {
      for (std::uint32_t column = 0; column < counts_.columns; ++column) {
        const int status = interrupted() ? stopped(refused) : make_tile(row, column);
        if (status != done) return status;
      }
    }
    if (report_.tiles.empty()) {
      throw InputError(command_.input.string(), "has no sample with data",
                       "check the value that means no data");
    }
    if (interrupted() && command_.writes_whole()) return stopped(refused);
    const int status = command_.writes_whole() ? write_joined() : done;
    return status == done && !report_.goal_reached ? unfinished : status;
  }

  // The run ends before its end.
  int stopped(int status) {
    report_.goal_reached = false;
    if (report_.error_kept) report_.error_kept = false;
    return status;
  }
  int failed(TerrainFigures tile, const std::string& problem, int status) {
    tile.problem = problem;
    report_.tiles.push_back(std::move(tile));
    return stopped(status);
  }

  int make_tile(std::uint32_t row, std::uint32_t column) {
    TerrainFigures figures;
    figures.name = "tile " + std::to_string(row) + " " + std::to_string(column);
    try {
      return make_tile(row, column, figures);
    } catch (const std::exception& error) {
      figures.output.clear();
      failed(figures, one_line(error), bad_input);
      throw;
    }
  }

  int make_tile(std::uint32_t row, std::uint32_t column, TerrainFigures& figures) {
    const GridWindow window = tile_window(region_, counts_, row, column);
    const auto start = Clock::now();
    GridPart part = file_.read_part(window);
    report_.seconds.read += seconds_since(start);
    job_.border_corners = border_corners(part);
    leave_to_neighbours(part);
    if (!part.grid.has_any_data()) return done;
    const GridPlace place{whole_, window.column, window.row};
    MadeTerrain made = make_terrain(part.grid, place, job_);
    if (interrupted()) return failed(figures, "cancelled", refused);
    made.finest.figures.name = figures.name;
    figures = made.finest.figures;
    complete_levels(made);
    add_to(report_, made.report);
    note_range();
    if (!made.report.valid) return failed(figures, "the result failed its own check", bug);
    if (!made.report.goal_reached && !command_.allow_unfinished) {
      return failed(figures, "the goal was not reached", unfinished);
    }
    const auto writing = Clock::now();
    if (command_.writes_tiles()) write_tile(made, tile_suffix(row, column));
    if (command_.writes_whole()) keep(made, shift_of(part.grid, place));
    report_.seconds.write += seconds_since(writing);
    report_.tiles.push_back(made.finest.figures);
    return done;
  }

  // A tile that did not get to a level does its best there.
  void complete_levels(MadeTerrain& made) const {
    while (made.coarser.size() < command_.coarser_levels()) {
      made.coarser.push_back(made.finest);
      made.report.levels.push_back(made.finest.figures);
    }
  }

  void write_tile(MadeTerrain& made, const std::string& suffix) {
    for (std::size_t i = 0; i < made.coarser.size(); ++i) {
      write_level(made.coarser[i], picture_, command_, suffix + level_suffix(i + 1));
    }
    write_level(made.finest, picture_, command_, suffix);
  }

  void keep(const MadeTerrain& made, Point shift) {
    joined_.resize(made.coarser.size() + 1);
    for (std::size_t i = 0; i < made.coarser.size(); ++i) {
      joined_[i].add(made.coarser[i].tin, shift);
    }
    joined_.back().add(made.finest.tin, shift);
  }

  int write_joined() {
    const auto start = Clock::now();
    int status = done;
    for (std::size_t i = 0; i + 1 < joined_.size() && status == done; ++i) {
      status = write_joined(joined_[i], report_.levels[i], level_suffix(i + 1));
    }
    if (status == done) status = write_joined(joined_.back(), report_.whole, "");
    report_.seconds.write += seconds_since(start);
    return status;
  }

  int write_joined(JoinedTin& tiles, TerrainFigures& figures, const std::string& suffix) {
    MadeTin made;
    made.tin = tiles.join(whole_.source);
    made.world = to_world(made.tin, whole_);
    figures.vertices = made.tin.mesh.vertex_count();
    const MeshReport checked = validate(made.world.mesh, {.delaunay = false});
    report_.violations.insert(report_.violations.end(), checked.violations.begin(),
                              checked.violations.end());
    report_.valid = report_.valid && checked.valid();
    if (!checked.valid()) return stopped(bug);
    write_level(made, picture_, command_, suffix);
    figures.output = made.figures.output;
    return done;
  }

  const TerrainCommand& command_;
  TerrainReport& report_;
  TileCounts counts_;
  HeightGridFile file_;
  const HeightGrid& whole_;  // without heights
  GridWindow region_;
  double lowest_ = INFINITY, highest_ = -INFINITY;
  HillshadeOptions picture_;
  TerrainJob job_;
  std::vector<JoinedTin> joined_;  // by level, the finest last
};

}  // namespace

int run_tiles(const TerrainCommand& command, TerrainReport& report) {
  return Tiles(command, report).run();
}

}  // namespace lepp::cli
