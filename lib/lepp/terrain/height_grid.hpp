#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lepp/geometry/point.hpp"
#include "lepp/terrain/heights.hpp"

namespace lepp {

/// A digital elevation model (DEM): heights on a grid, and where the grid lies in the world.
///
/// Two frames are used. World coordinates are the file's: x = origin.x + column * step_x,
/// y = origin.y + row * step_y, where row 0 is the first row of the file (the northern one if
/// step_y < 0). Grid space is what everything is computed in: x = column, y = row * aspect, counted
/// from the southern row, so that y grows as the world's y does. A cell is 1 wide in grid space and
/// `aspect` high, its true proportions to 24 bits: so row * aspect is exact, samples on a line are
/// exactly collinear whatever the cell is like, and all predicates are fast.
struct HeightGrid {
  std::uint32_t columns = 0, rows = 0;
  Heights heights;  ///< row by row, row 0 first; NaN where there is no data

  Point origin;                ///< world coordinates of sample (0, 0): pixel centres
  double step_x = 1;           ///< world distance from column to column, > 0
  double step_y = -1;          ///< from row to row; < 0: row 0 is the northern one
  bool georeferenced = false;  ///< false: the three above are made up
  bool degrees = false;        ///< world coordinates are longitude and latitude
  std::string crs;             ///< coordinate reference system as WKT, or empty
  /// Width and height of a cell in the unit of the heights, as far as known: of geographic grids
  /// in metres at the middle latitude.
  double cell_width = 1, cell_height = 1;
  std::string source;                 ///< what messages call it
  std::vector<std::string> warnings;  ///< of the reader: one sentence each, ready to print
  std::vector<std::string> files;     ///< that were read besides: parts of a mosaic, a .prj

  double aspect() const {
    // By bits: gcc 12 at -O3 drops the rounding of double(float(x)) where it vectorises.
    constexpr std::uint64_t half = std::uint64_t{1} << 28;
    const auto bits = std::bit_cast<std::uint64_t>(cell_height / cell_width);
    return std::bit_cast<double>((bits + half) & ~(2 * half - 1));
  }
  bool north_first() const { return step_y < 0; }
  std::size_t size() const { return std::size_t{columns} * rows; }
  std::size_t index(std::uint32_t column, std::uint32_t row) const {
    return std::size_t{row} * columns + column;
  }
  double height(std::uint32_t column, std::uint32_t row) const {
    return heights[index(column, row)];
  }
  bool has_data(std::uint32_t column, std::uint32_t row) const {
    return !std::isnan(height(column, row));
  }
  bool has_any_data() const;

  /// The row of the file that is `line` lines north of the southern one, and back.
  std::uint32_t row_of_line(std::uint32_t line) const {
    return north_first() ? rows - 1 - line : line;
  }
  /// Grid space: the place of a sample, `line` counted from the south.
  Point sample(std::uint32_t column, std::uint32_t line) const {
    return {double(column), double(line) * aspect()};
  }
  Point to_world(Point p) const {
    const double line = p.y / aspect();
    const double row = north_first() ? double(rows - 1) - line : line;
    return {origin.x + p.x * step_x, origin.y + row * step_y};
  }
  Point to_grid(Point world) const {
    const double row = (world.y - origin.y) / step_y;
    const double line = north_first() ? double(rows - 1) - row : row;
    return {(world.x - origin.x) / step_x, line * aspect()};
  }
};

/// A part of a grid: `columns` x `rows` samples from (column, row) on, counted as in the file.
struct GridWindow {
  std::uint32_t column = 0, row = 0;
  std::uint32_t columns = 0, rows = 0;
};

/// Cells of a grid in degrees get their size in metres, at the middle latitude of the grid, on the
/// ellipsoid of WGS84 and GRS80.
/// \throw InputError  the middle latitude is no latitude
void set_cell_from_degrees(HeightGrid& grid);

/// \throw InputError  a grid of one row or column, or without any data
void check_usable(const HeightGrid& grid);

}  // namespace lepp
