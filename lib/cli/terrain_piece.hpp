#pragma once

#include <optional>
#include <string>
#include <vector>

#include "terrain_options.hpp"
#include "terrain_run.hpp"

namespace lepp::cli {

/// What is meshed in one piece: a grid, or a window of one.
struct Piece {
  std::optional<HeightGrid> whole;  ///< without heights, where `grid` is a window of it
  GridWindow window;
  HeightGrid grid;
  BorderCorners corners;               ///< of a window beside others
  std::size_t left_to_neighbours = 0;  ///< samples of the window that are meshed by those

  GridPlace place() const {
    return whole ? GridPlace{*whole, window.column, window.row} : GridPlace{grid};
  }
};

/// Reads the heights that a command without tiles asks for.
Piece read_piece(const TerrainCommand& command);

/// What is to become of it. Reads lines, too.
TerrainJob job_of(const TerrainCommand& command, const Piece& piece,
                  std::vector<std::string>& warnings);

/// Warns where lengths are measured in space and the coordinate reference system has them in
/// another unit than heights: nothing is converted but degrees.
void warn_of_units(const TerrainCommand& command, const HeightGrid& grid,
                   std::vector<std::string>& warnings);

/// From now on coordinates count from `origin`, those of lines included, which were read in the
/// coordinates of the file.
void count_from_origin(Point origin, Piece& piece, DomainOptions& domain,
                       std::vector<std::string>& warnings);

}  // namespace lepp::cli
