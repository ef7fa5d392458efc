#include "regions.hpp"

#include "lepp/geometry/error.hpp"
#include "lepp/io/line_reader.hpp"
#include "lepp/io/text_file.hpp"

namespace lepp::cli {

namespace {

PolygonArea read_polygon(const std::string& path) {
  const TextFile file = read_text_file(path);
  LineReader line(file);
  PolygonArea polygon;
  while (line.next()) {
    line.expect_fields(2, 2, "x y");
    polygon.corners.push_back({line.coordinate(0, "x"), line.coordinate(1, "y")});
  }
  if (polygon.corners.size() < 3) {
    throw InputError(file.name, "holds fewer than three corners", "write a line 'x y' for each");
  }
  return polygon;
}

}  // namespace

Region read_region(const std::string& text) {
  const TextFile words{"--in \"" + text + "\"", text};
  LineReader line(words);
  if (line.next()) {
    const auto coordinate = [&](std::size_t i) { return line.coordinate(i, "a coordinate"); };
    if (line.field(0) == "disc") {
      line.expect_fields(4, 4, "disc X Y R");
      const Disc disc{{coordinate(1), coordinate(2)}, coordinate(3)};
      if (disc.radius >= 0) return disc;
      line.fail("the radius is negative", "give a length");
    }
    if (line.field(0) == "box") {
      line.expect_fields(5, 5, "box X0 Y0 X1 Y1");
      const Box box{{coordinate(1), coordinate(2)}, {coordinate(3), coordinate(4)}};
      if (box.low.x <= box.high.x && box.low.y <= box.high.y) return box;
      line.fail("the first corner lies right of the second, or above it",
                "give the lower left corner, then the upper right one");
    }
    const std::string_view kind = "polygon ";
    if (text.starts_with(kind)) return read_polygon(text.substr(kind.size()));
  }
  throw InputError(words.name, "is no region",
                   "write \"disc X Y R\", \"box X0 Y0 X1 Y1\" or \"polygon FILE\"");
}

}  // namespace lepp::cli
