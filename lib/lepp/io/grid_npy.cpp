// NumPy's .npy, versions 1 to 3: magic, version, length of the header, a Python dictionary,
// samples.
#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <string_view>

#include "lepp/geometry/error.hpp"
#include "lepp/io/raster_layout.hpp"

namespace lepp {

namespace {

using namespace std::string_view_literals;

class NpyHeader {
 public:
  explicit NpyHeader(const InputFile& file) : file_(file) {}

  BinaryRaster read() {
    find_text();
    BinaryRaster raster;
    raster.grid.source = file_.name();
    const std::array<double, 2> shape = read_shape();  // rows, columns
    set_size(raster.grid, shape[1], shape[0]);
    raster.layout.offset = end_;
    read_type(raster.layout);
    raster.layout.by_columns = value_of("fortran_order").starts_with("True");
    if (!raster.layout.by_columns && !value_of("fortran_order").starts_with("False"))
      fail("fortran_order is neither True nor False", "write the array again with numpy.save");
    check_bytes(file_, raster);
    return raster;
  }

 private:
  // The dictionary.
  void find_text() {
    constexpr std::size_t most = 1 << 16;  // numpy itself writes less than 200 bytes
    head_ = file_.head(12 + most);
    const auto byte = [&](std::size_t i) {
      return i < head_.size() ? static_cast<unsigned char>(head_[i]) : 0U;
    };
    const unsigned version = byte(6);
    if (version < 1 || version > 3)
      fail("is of version " + std::to_string(version), "write it with a version from 1 to 3");
    const std::size_t begin = version == 1 ? 10 : 12;
    std::size_t length = byte(8) + (byte(9) << 8);
    if (version > 1) length += (std::size_t{byte(10)} << 16) + (std::size_t{byte(11)} << 24);
    if (length > most || begin + length > head_.size())
      fail("its header is longer than the file, or than 64 KiB", "export it again");
    end_ = begin + length;
    text_ = std::string_view(head_).substr(begin, length);
  }

  std::string_view value_of(std::string_view key) const {
    const std::size_t at = text_.find(key);
    const std::size_t colon = at == text_.npos ? at : text_.find(':', at);
    const std::size_t value = colon == text_.npos ? colon : text_.find_first_not_of(" :", colon);
    if (value == text_.npos)
      fail("its header has no " + std::string(key), "write the array again with numpy.save");
    return text_.substr(value);
  }

  void read_type(RasterLayout& layout) const {
    const std::string_view value = value_of("descr");
    const std::string_view quoted = value.substr(std::min<std::size_t>(1, value.size()));
    const std::string_view type = quoted.substr(0, quoted.find_first_of("'\""));
    constexpr std::array names = {"u1"sv, "i1"sv, "u2"sv, "i2"sv, "u4"sv,
                                  "i4"sv, "u8"sv, "i8"sv, "f4"sv, "f8"sv};
    const auto* const found =
        type.size() == 3 ? std::ranges::find(names, type.substr(1)) : names.end();
    if (found == names.end() || "<>|="sv.find(type[0]) == std::string_view::npos) {
      fail("its values are of type \"" + std::string(type.substr(0, 40)) + "\"",
           "convert them: array.astype('float32'); f4, f8 and integers are read");
    }
    layout.type = static_cast<SampleType>(found - names.begin());
    layout.big_endian = type[0] == '>';
  }

  std::array<double, 2> read_shape() const {
    const std::string_view value = value_of("shape");
    const std::string_view inside = value.substr(0, value.find(')'));
    std::array<double, 2> shape{};
    std::size_t count = 0;
    for (const char* c = inside.data(); c != inside.data() + inside.size();) {
      if (*c < '0' || *c > '9') {
        ++c;
        continue;
      }
      double size = 0;
      c = std::from_chars(c, inside.data() + inside.size(), size, std::chars_format::fixed).ptr;
      if (count < 2) shape[count] = size;
      ++count;
    }
    if (count != 2) {
      fail("is an array of " + std::to_string(count) + " dimensions",
           "save an array of two dimensions, rows and columns");
    }
    return shape;
  }

  [[noreturn]] void fail(std::string problem, std::string remedy) const {
    throw InputError(file_.name(), std::move(problem), std::move(remedy));
  }

  const InputFile& file_;
  std::string head_;
  std::string_view text_;
  std::size_t end_ = 0;
};

}  // namespace

std::optional<BinaryRaster> npy_header(const InputFile& file) {
  if (!file.head(6).starts_with("\x93NUMPY")) return std::nullopt;
  return NpyHeader(file).read();
}

}  // namespace lepp
