#pragma once

#include <cstdint>
#include <optional>

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

/// Reads the heights of a window; all of the file is passed. `grid` is grid_of_window().
/// \throw InputError  naming the line: a height is missing, too much, infinite or no number
/// \throw RefusedError  more memory than the machine has
/// Cost   over 100 MB of text a second; memory for the heights, which are doubles if one of them is
///        no float, and less than a MiB
void read_text_heights(const InputFile& file, const TextRaster& whole, const GridWindow& window,
                       HeightGrid& grid);

}  // namespace lepp
