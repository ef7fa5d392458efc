// "STM columns rows abcd\n" and unsigned 16-bit integers, row by row. The bytes a, b, c, d are the
// number 0x04030201 in the byte order of what follows.
#include <string>
#include <string_view>

#include "lepp/geometry/error.hpp"
#include "lepp/io/header_words.hpp"
#include "lepp/io/raster_layout.hpp"

namespace lepp {

std::optional<BinaryRaster> stm_header(const InputFile& file) {
  const std::string head = file.head(256);
  if (!head.starts_with("STM ")) return std::nullopt;
  const std::size_t rows_at = head.find(' ', 4), order_at = head.find(' ', rows_at + 1);
  const bool complete = rows_at != head.npos && order_at != head.npos &&
                        order_at + 6 <= head.size() && head[order_at + 5] == '\n';
  const std::string_view order =
      complete ? std::string_view(head).substr(order_at + 1, 4) : std::string_view();
  if (order != "\4\3\2\1" && order != "\1\2\3\4") {
    throw InputError(file.name() + ", line 1",
                     "is not 'STM columns rows' and the four bytes 4 3 2 1",
                     "write them, separated by single spaces, and end the line");
  }
  BinaryRaster raster;
  raster.grid.source = file.name();
  const std::string_view text = head;
  set_size(raster.grid, header_number(file, text.substr(4, rows_at - 4)),
           header_number(file, text.substr(rows_at + 1, order_at - rows_at - 1)));
  raster.layout = {order_at + 6, SampleType::u16, order == "\4\3\2\1", false, {}};
  check_bytes(file, raster);
  return raster;
}

}  // namespace lepp
