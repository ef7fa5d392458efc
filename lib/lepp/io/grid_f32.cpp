// "F32 columns rows nodata\n", then little-endian floats, row by row: what a few lines of any
// language write.
#include <string>

#include "lepp/geometry/error.hpp"
#include "lepp/io/header_words.hpp"
#include "lepp/io/raster_layout.hpp"

namespace lepp {

std::optional<BinaryRaster> f32_header(const InputFile& file) {
  const std::string head = file.head(256);
  if (!head.starts_with("F32 ")) return std::nullopt;
  const std::size_t end = head.find('\n');
  const auto words = words_of(std::string_view(head).substr(0, std::min(end, head.size())));
  if (end == head.npos || words.size() != 4) {
    throw InputError(file.name() + ", line 1", "is not 'F32 columns rows nodata'",
                     "write these four words, separated by single spaces, and end the line");
  }
  BinaryRaster raster;
  raster.grid.source = file.name();
  set_size(raster.grid, header_number(file, words[1]), header_number(file, words[2]));
  raster.layout = {end + 1, SampleType::f32, false, false, header_number(file, words[3])};
  check_bytes(file, raster);
  return raster;
}

}  // namespace lepp
