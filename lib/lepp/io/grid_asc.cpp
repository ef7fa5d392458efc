// ESRI ASCII: keys and numbers in any case and order, then heights from the northern row on.
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/io/text_grid.hpp"

namespace lepp {

namespace {

enum Key { columns, rows, x_corner, y_corner, x_center, y_center, cell, dx, dy, nodata, keys };
constexpr std::array<const char*, keys> names = {
    "ncols",     "nrows",    "xllcorner", "yllcorner", "xllcenter",
    "yllcenter", "cellsize", "dx",        "dy",        "nodata_value"};

bool starts_a_number(std::string_view word) {
  const char c = word[0];
  return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' ||
         lower_case(word.substr(0, 3)) == "nan" || lower_case(word.substr(0, 3)) == "inf";
}

class AscHeader {
 public:
  explicit AscHeader(const InputFile& file) : file_(file), stream_(file) {}

  TextRaster read() {
    read_keys();
    TextRaster raster;
    raster.grid.source = file_.name();
    raster.offset = file_.size() - stream_.bytes_left();
    raster.line = stream_.line();
    set_size(raster.grid, needed(columns), needed(rows));
    raster.nodata = values_[nodata].value_or(-9999);
    place(raster.grid);
    return raster;
  }

 private:
  void read_keys() {
    std::string_view word;
    while (stream_.next(word)) {
      if (starts_a_number(word)) {
        stream_.put_back();
        return;
      }
      if (word.starts_with("\xEF\xBB\xBF")) word.remove_prefix(3);
      read_value(key_of(word));
    }
    fail("it has a header, but no heights", "the file is cut short: export it again");
  }

  std::size_t key_of(std::string_view word) {
    const std::string text = lower_case(word.substr(0, 40));
    for (std::size_t i = 0; i < keys; ++i) {
      if (text == names[i]) return i;
    }
    std::string shown;
    for (const char c : text) shown += c >= ' ' && c <= '~' ? c : '?';
    fail("\"" + shown + "\" is no key of an ESRI ASCII grid",
         "the keys are ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize or "
         "dx and dy, NODATA_value");
  }

  void read_value(std::size_t key) {
    std::string_view word;
    if (!stream_.next(word)) fail(std::string(names[key]) + " has no value", "add it");
    const double value = stream_.number(word);
    if (values_[key]) fail(std::string(names[key]) + " occurs twice", "remove one");
    const bool size = key == cell || key == dx || key == dy;
    if (key != nodata && !std::isfinite(value))
      fail(std::string(names[key]) + " is not finite", "correct it");
    if (size && !(value > 0))
      fail(std::string(names[key]) + " is " + to_text(value), "it must be above 0: correct it");
    if ((key == columns || key == rows) && !(value >= 1))
      fail(std::string(names[key]) + " is " + to_text(value), "it must be above 0: correct it");
    values_[key] = value;
  }

  double needed(Key key) const {
    if (values_[key]) return *values_[key];
    throw InputError(file_.name() + ", header", std::string(names[key]) + " is missing", "add it");
  }

  // The low end of an axis: of the first pixel, or of its center.
  double center_of_first(Key corner, Key center, double size) const {
    if (values_[corner] && values_[center]) {
      throw InputError(file_.name() + ", header",
                       std::string(names[corner]) + " and " + names[center] + " are both there",
                       "remove one");
    }
    return values_[center] ? *values_[center] : needed(corner) + size / 2;
  }

  void place(HeightGrid& grid) const {
    if (values_[cell] && (values_[dx] || values_[dy])) {
      throw InputError(file_.name() + ", header", "cellsize and dx, dy are both there",
                       "remove one");
    }
    const bool square = !values_[dx] && !values_[dy];
    grid.cell_width = square ? needed(cell) : needed(dx);
    grid.cell_height = square ? needed(cell) : needed(dy);
    grid.step_x = grid.cell_width;
    grid.step_y = -grid.cell_height;
    grid.origin.x = center_of_first(x_corner, x_center, grid.cell_width);
    grid.origin.y = center_of_first(y_corner, y_center, grid.cell_height) +
                    double(grid.rows - 1) * grid.cell_height;
    grid.georeferenced = true;
  }

  [[noreturn]] void fail(std::string problem, std::string remedy) const {
    throw InputError(stream_.where(), std::move(problem), std::move(remedy));
  }

  const InputFile& file_;
  NumberStream stream_;
  std::array<std::optional<double>, keys> values_;
};

}  // namespace

TextRaster asc_header(const InputFile& file) { return AscHeader(file).read(); }

}  // namespace lepp
