// PGM, plain (P2) and raw (P5): size and largest value, then heights up to 65535.
#include <array>

#include "lepp/geometry/error.hpp"
#include "lepp/io/raster_layout.hpp"
#include "lepp/io/text_grid.hpp"

namespace lepp {

namespace {

struct PgmHeader {
  HeightGrid grid;
  double largest = 0;
  std::uint64_t offset = 0;  // of the first byte behind the largest value
  std::int64_t line = 1;
};

PgmHeader read_header(const InputFile& file) {
  NumberStream stream(file);
  std::string_view word;
  stream.next(word);  // the kind
  std::array<double, 3> numbers{};
  PgmHeader header;
  for (std::size_t i = 0; i < numbers.size();) {
    if (!stream.next(word))
      throw InputError(file.name(), "the header is cut short", "export the file again");
    if (word.starts_with('#')) {
      stream.skip_line();
      continue;
    }
    numbers[i++] = stream.number(word);
    header.offset = file.size() - stream.bytes_left() + word.size();
    header.line = stream.line();
  }
  header.grid.source = file.name();
  set_size(header.grid, numbers[0], numbers[1]);
  header.largest = numbers[2];
  if (!(header.largest >= 1 && header.largest <= 65535))
    throw InputError(stream.where(), "the largest value is not between 1 and 65535",
                     "export the file again");
  return header;
}

}  // namespace

std::optional<BinaryRaster> pgm_header(const InputFile& file) {
  if (!file.head(2).starts_with("P5")) return std::nullopt;
  PgmHeader header = read_header(file);
  const SampleType type = header.largest < 256 ? SampleType::u8 : SampleType::u16;
  BinaryRaster raster{std::move(header.grid), {header.offset + 1, type, true, false, {}}};
  check_bytes(file, raster);
  return raster;
}

std::optional<TextRaster> plain_pgm_header(const InputFile& file) {
  if (!file.head(2).starts_with("P2")) return std::nullopt;
  PgmHeader header = read_header(file);
  return TextRaster{std::move(header.grid), header.offset, header.line, {}, true};
}

}  // namespace lepp
