#include "lepp/io/png.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "lepp/io/atomic_files.hpp"
#include "lepp/io/binary_numbers.hpp"

namespace lepp {

namespace {

std::string_view as_text(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

constexpr std::array<std::uint32_t, 256> crc_table = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t n = 0; n < 256; ++n) {
    std::uint32_t c = n;
    for (int k = 0; k < 8; ++k) c = (c & 1U) != 0 ? 0xEDB88320U ^ (c >> 1) : c >> 1;
    table[n] = c;
  }
  return table;
}();

// A chunk: length, type, data, and a checksum of the last two. Written as it comes.
class Chunk {
 public:
  Chunk(OutputFile& out, std::string_view type, std::size_t length) : out_(out) {
    BinaryFile<std::endian::big>(out).put(static_cast<std::uint32_t>(length));
    text(type);
  }
  void text(std::string_view text) {
    for (const char c : text) {
      crc_ = crc_table[(crc_ ^ static_cast<std::uint8_t>(c)) & 0xFFU] ^ (crc_ >> 8);
    }
    out_ << text;
  }
  template <std::endian order, class Number>
  void put(Number number) {
    const auto bytes = bytes_of<order>(number);
    text({bytes.data(), bytes.size()});
  }
  void end() { BinaryFile<std::endian::big>(out_).put(crc_ ^ 0xFFFFFFFFU); }

 private:
  OutputFile& out_;
  std::uint32_t crc_ = 0xFFFFFFFFU;
};

std::uint32_t adler32(std::span<const std::uint8_t> bytes) {
  std::uint32_t a = 1, b = 0;
  for (const std::uint8_t byte : bytes) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  return b << 16 | a;
}

void write_header(OutputFile& out, std::size_t width, std::size_t height) {
  Chunk chunk(out, "IHDR", 13);
  chunk.put<std::endian::big>(static_cast<std::uint32_t>(width));
  chunk.put<std::endian::big>(static_cast<std::uint32_t>(height));
  chunk.text(std::string_view("\x08\x02\0\0\0", 5));  // 8 bits, colours, plain
  chunk.end();
}

void write_pixels(OutputFile& out, std::span<const std::uint8_t> bytes) {
  constexpr std::size_t block = 65535;
  const std::size_t blocks = (bytes.size() + block - 1) / block;
  Chunk chunk(out, "IDAT", 2 + bytes.size() + 5 * blocks + 4);
  chunk.text("\x78\x01");
  for (std::size_t at = 0; at < bytes.size(); at += block) {
    const auto part = bytes.subspan(at, std::min(block, bytes.size() - at));
    const auto length = static_cast<std::uint16_t>(part.size());
    chunk.put<std::endian::little>(std::uint8_t{at + part.size() == bytes.size()});
    chunk.put<std::endian::little>(length);
    chunk.put<std::endian::little>(static_cast<std::uint16_t>(~length));
    chunk.text(as_text(part));
  }
  chunk.put<std::endian::big>(adler32(bytes));
  chunk.end();
}

}  // namespace

void write_png(const std::filesystem::path& path, std::size_t width, std::size_t height,
               std::span<const std::uint8_t> colors) {
  std::vector<std::uint8_t> rows;  // each behind the number of its filter, 0
  rows.reserve(colors.size() + height);
  for (std::size_t row = 0; row < height; ++row) {
    rows.push_back(0);
    const auto of_row = colors.subspan(3 * width * row, 3 * width);
    rows.insert(rows.end(), of_row.begin(), of_row.end());
  }
  AtomicFiles files;
  OutputFile& out = files.add(path);
  out << "\x89PNG\r\n\x1A\n";
  write_header(out, width, height);
  write_pixels(out, rows);
  Chunk(out, "IEND", 0).end();
  files.commit();
}

}  // namespace lepp
