#include "terrain_piece.hpp"

#include <cmath>

#include "lepp/geometry/text.hpp"
#include "lepp/io/crs_wkt.hpp"
#include "lepp/io/raster_layout.hpp"
#include "terrain_reports.hpp"

namespace lepp::cli {

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
    piece.left_to_neighbours = leave_to_neighbours(part);
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
  job.lists_prefixes = command.prefix_errors;
  return job;
}

void warn_of_units(const TerrainCommand& command, const HeightGrid& grid,
                   std::vector<std::string>& warnings) {
  const bool in_space = command.metric == TerrainMetric::surface || !command.picture.empty();
  if (!in_space || command.cell.size() == 2) return;
  const CrsWkt crs = parse_crs_wkt(grid.crs);
  const std::optional<double> unit = grid.degrees ? std::optional(1.0) : crs.unit;
  if (!unit || (crs.is_geographic && !grid.degrees)) return;  // not known
  const double of_heights = crs.height_unit.value_or(1);
  if (std::abs(*unit / of_heights - 1) < 1e-5) return;  // of two sorts of feet, too
  const auto named = [](double metres) {
    return name_of_unit(metres).value_or("units of " + lepp::to_text(metres) + " m");
  };
  warnings.push_back(
      "cells are measured in " + named(*unit) + " and heights are taken in the same unit" +
      (crs.height_unit ? ", though the file says " + named(of_heights) : std::string()) +
      "; if they are in another one, give the size of cells in that: --cell");
}

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

}  // namespace lepp::cli
