#include "regions.hpp"

#include <string_view>

#include "lepp/geometry/error.hpp"
#include "lepp/io/line_reader.hpp"
#include "lepp/io/text_file.hpp"

namespace lepp::cli {

namespace fs = std::filesystem;

namespace {

PolygonArea read_polygon(const fs::path& path) {
  const TextFile file = read_text_file(path);
  LineReader line(file);
  std::vector<Point> corners;
  while (line.next()) {
    line.expect_fields(2, 2, "x y");
    corners.push_back({line.coordinate(0, "x"), line.coordinate(1, "y")});
  }
  if (corners.size() < 3) {
    throw InputError(file.name, "holds fewer than three corners", "write a line 'x y' for each");
  }
  return corners;
}

constexpr std::string_view blanks = " \t\r\n";

std::string_view without_blanks_around(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

std::string name_of(const std::string& text) { return "--in \"" + text + "\""; }

Disc disc_of(const LineReader& line) {
  line.expect_fields(4, 4, "disc X Y R");
  const Disc disc{{line.coordinate(1, "X"), line.coordinate(2, "Y")}, line.coordinate(3, "R")};
  if (!(disc.radius >= 0)) line.fail("the radius is negative", "give a length");
  return disc;
}

Box box_of(const LineReader& line) {
  line.expect_fields(5, 5, "box X0 Y0 X1 Y1");
  const Box box{{line.coordinate(1, "X0"), line.coordinate(2, "Y0")},
                {line.coordinate(3, "X1"), line.coordinate(4, "Y1")}};
  if (!(box.low.x <= box.high.x && box.low.y <= box.high.y)) {
    line.fail("the first corner lies right of the second, or above it",
              "give the lower left corner, then the upper right one");
  }
  return box;
}

}  // namespace

// A name may have blanks within, so it is all that follows the first word.
std::optional<fs::path> polygon_file(const std::string& text) {
  constexpr std::string_view kind = "polygon";
  const std::string_view words = without_blanks_around(text);
  if (!words.starts_with(kind)) return std::nullopt;
  const std::string_view file = without_blanks_around(words.substr(kind.size()));
  if (file.empty()) throw InputError(name_of(text), "names no file", "write \"polygon FILE\"");
  if (words.find_first_of(blanks) != kind.size()) return std::nullopt;
  return fs::path(file);
}

Region read_region(const std::string& text) {
  if (const auto file = polygon_file(text)) return read_polygon(*file);
  const TextFile words{name_of(text), text};
  LineReader line(words);
  std::optional<Region> region;
  if (line.next()) {
    if (line.field(0) == "disc") region = disc_of(line);
    else if (line.field(0) == "box") region = box_of(line);
  }
  if (region && line.next()) {
    line.fail("one --in is one region", "give --in once more for the next one");
  }
  if (region) return *region;
  throw InputError(words.name, "is no region",
                   "write \"disc X Y R\", \"box X0 Y0 X1 Y1\" or \"polygon FILE\"");
}

}  // namespace lepp::cli
