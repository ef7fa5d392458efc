#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lepp/io/number_stream.hpp"
#include "lepp/io/raster_layout.hpp"
#include "lepp/io/sample_values.hpp"

namespace lepp {

/// The header of a grid whose heights are text, and where they begin.
struct TextRaster {
  HeightGrid grid;
  std::uint64_t offset = 0;  ///< in the file
  std::int64_t line = 1;     ///< of that place
  std::optional<double> nodata;
  bool comments = false;  ///< '#' starts one
};

/// ESRI ASCII. \throw InputError  a key missing, unknown or twice; sizes that make no sense
TextRaster asc_header(const InputFile& file);
/// PGM of kind P2; nothing for another file.
std::optional<TextRaster> plain_pgm_header(const InputFile& file);

/// A place in a text grid: a byte, and the line that it is on.
struct TextPlace {
  std::uint64_t offset = 0;
  std::int64_t line = 1;
};

/// Where every `step`-th row of heights begins; nothing before a first pass over the file.
struct TextRows {
  std::uint32_t step = 1;
  std::vector<TextPlace> begins;
};

/// Reads the heights of a window; `grid` is grid_of_window(). If `rows` is empty, all of the file
/// is passed and checked, and `rows` filled; else no more is passed than some rows before the
/// window. \throw InputError  naming the line: a height is missing, too much, infinite or no
/// number; or the
///                    file has become shorter since `rows` was filled
/// \throw RefusedError  more memory than the machine has
/// Cost   over 100 MB of text a second; memory for the heights, which are doubles if one of them is
///        no float, and less than a MiB
void read_text_heights(const InputFile& file, const TextRaster& whole, const GridWindow& window,
                       HeightGrid& grid, TextRows& rows);

}  // namespace lepp
