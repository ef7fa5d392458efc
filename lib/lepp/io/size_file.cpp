#include "lepp/io/size_file.hpp"

#include "lepp/geometry/error.hpp"
#include "lepp/io/line_reader.hpp"
#include "lepp/io/text_file.hpp"

namespace lepp {

std::vector<SizeSource> read_size_file(const std::filesystem::path& path) {
  const TextFile file = read_text_file(path);
  LineReader line(file);
  std::vector<SizeSource> sources;
  while (line.next()) {
    if (line.fields() == 1 && line.field(0).find_first_of(",;") != std::string_view::npos) {
      line.fail("its numbers are not separated by blanks", "write 'x y size', such as 0.5 0.5 0.1");
    }
    line.expect_fields(3, 3, "x y size");
    const Point at{line.coordinate(0, "x"), line.coordinate(1, "y")};
    const double size = line.number(2, "the size");
    if (!(size > 0)) line.fail("the size is not above 0", "give the longest edge wanted there");
    sources.push_back({at, size, true});
  }
  if (sources.empty()) {
    throw InputError(file.name, "holds no sizes", "write lines 'x y size'");
  }
  return sources;
}

}  // namespace lepp
