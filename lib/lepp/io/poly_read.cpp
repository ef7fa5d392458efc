#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/io/entity_table.hpp"
#include "lepp/io/file_kind.hpp"
#include "lepp/io/line_reader.hpp"
#include "lepp/io/poly.hpp"
#include "lepp/io/text_file.hpp"

namespace lepp {

namespace {

namespace fs = std::filesystem;

struct Vertices {
  std::vector<Point> points;
  std::int64_t base = 0;

  std::string range() const {
    return std::to_string(base) + ".." +
           std::to_string(base + static_cast<std::int64_t>(points.size()) - 1);
  }
};

struct MarkedSegment {
  VertexId a, b;
  int marker = 0;
};

// Checks the number that starts a record.
void check_number(const LineReader& line, std::int64_t number, const Record& wanted) {
  if (number == wanted.number) return;
  line.fail(Record{wanted.kind, number}.text() + " stands where " + wanted.text() + " belongs",
            "number them one after the other");
}

// What is missing where a file ends too early.
std::string next_of(std::string_view what, std::size_t done, std::size_t count) {
  return std::string(what) + " (" + std::to_string(done) + " of " + std::to_string(count) +
         " are there)";
}

VertexId vertex(const LineReader& line, std::size_t field, const Vertices& vertices,
                const Record& whose) {
  const std::int64_t number = line.integer(field, {"a vertex of ", whose});
  const std::int64_t index = number - vertices.base;
  if (index < 0 || static_cast<std::uint64_t>(index) >= vertices.points.size()) {
    line.fail(whose.text() + " refers to vertex " + std::to_string(number) +
                  ", but the vertices are " + vertices.range(),
              "correct the number, or add the vertex");
  }
  return VertexId(static_cast<std::size_t>(index));
}

int marker(const LineReader& line, std::size_t field, const Record& whose) {
  const std::int64_t value = line.integer(field, {"the marker of ", whose});
  if (std::abs(value) > 2147483647) {
    line.fail("the marker of " + whose.text() + " is " + std::to_string(value) + ", beyond 32 bits",
              "use smaller markers");
  }
  return static_cast<int>(value);
}

std::size_t optional_flag(const LineReader& line, std::size_t field, const Label& what) {
  if (field >= line.fields()) return 0;
  const std::int64_t value = line.integer(field, what);
  if (value != 0 && value != 1) {
    line.fail(what.text() + " is " + std::to_string(value), "write 0 or 1");
  }
  return static_cast<std::size_t>(value);
}

// The header "vertices dimension attributes markers" and the vertices.
Vertices read_vertices(LineReader& line) {
  line.need("the header of the vertices");
  line.expect_fields(1, 4, "vertices, dimension, attributes, markers");
  const std::int64_t dimension = line.fields() > 1 ? line.integer(1, "the dimension") : 2;
  if (dimension != 2) {
    line.fail("dimension " + std::to_string(dimension) + " in a file that must be 2-D",
              "project the points to the plane and write dimension 2");
  }
  const std::size_t attributes = line.fields() > 2 ? line.count(2, "attributes", 1) : 0;
  const std::size_t markers = optional_flag(line, 3, "the number of vertex markers");
  const std::size_t count = line.count(0, "vertices", 6);  // last: the others may be the culprit
  Vertices vertices;
  vertices.points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!line.next()) line.ends_before(next_of("a vertex", i, count));
    const std::int64_t number = line.integer(0, "the number of the vertex");
    if (i == 0 && (number == 0 || number == 1)) vertices.base = number;
    const Record own{"vertex", vertices.base + static_cast<std::int64_t>(i)};
    check_number(line, number, own);
    line.expect_fields(3 + attributes, 3 + attributes + markers,
                       {"", own, " has number, x, y, attributes and marker as the header says"});
    const double x = line.coordinate(1, {"x of ", own});
    const double y = line.coordinate(2, {"y of ", own});
    for (std::size_t k = 0; k < attributes; ++k) line.number(3 + k, {"an attribute of ", own});
    if (line.fields() > 3 + attributes) marker(line, 3 + attributes, own);
    vertices.points.push_back({x, y});
  }
  return vertices;
}

std::vector<MarkedSegment> read_segments(LineReader& line, const Vertices& vertices,
                                         std::string_view what) {
  line.need("the header of the " + std::string(what) + "s");
  line.expect_fields(1, 2, "the number of " + std::string(what) + "s, and 1 if they have markers");
  const std::size_t count = line.count(0, std::string(what) + "s", 6);
  const std::size_t markers = optional_flag(line, 1, "the number of markers");
  std::vector<MarkedSegment> segments;
  segments.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!line.next()) line.ends_before("a " + std::string(what));
    const Record own{what, vertices.base + static_cast<std::int64_t>(i)};
    check_number(line, line.integer(0, {"the number of ", own}), own);
    line.expect_fields(3, 3 + markers, {"the number, two vertices and the marker of ", own});
    const VertexId a = vertex(line, 1, vertices, own);
    const VertexId b = vertex(line, 2, vertices, own);
    segments.push_back({a, b, line.fields() > 3 ? marker(line, 3, own) : 0});
  }
  return segments;
}

std::vector<Segment> on_curves(const std::vector<MarkedSegment>& marked, EntityTable& table) {
  std::vector<Segment> segments;
  segments.reserve(marked.size());
  for (const MarkedSegment& s : marked) {
    Segment segment{s.a, s.b, std::nullopt, 0, 1};
    if (s.marker != 0) segment.curve = table.curve(s.marker);
    segments.push_back(segment);
  }
  return segments;
}

std::vector<Point> read_holes(LineReader& line) {
  line.need("the number of holes");
  line.expect_fields(1, 1, "the number of holes");
  const std::size_t count = line.count(0, "holes", 6);
  std::vector<Point> holes;
  for (std::size_t i = 0; i < count; ++i) {
    line.need("a hole");
    const Record own{"hole", line.integer(0, "the number of the hole")};
    line.expect_fields(3, 3, {"the number, x and y of ", own});
    holes.push_back({line.coordinate(1, {"x of ", own}), line.coordinate(2, {"y of ", own})});
  }
  return holes;
}

std::vector<RegionSeed> read_regions(LineReader& line, EntityTable& table) {
  std::vector<RegionSeed> seeds;
  if (!line.next()) return seeds;
  line.expect_fields(1, 1, "the number of regions, and nothing after the last hole but that");
  const std::size_t count = line.count(0, "regions", 8);
  for (std::size_t i = 0; i < count; ++i) {
    line.need("a region");
    const Record own{"region", line.integer(0, "the number of the region")};
    line.expect_fields(4, 5, {"number, x, y, attribute and area limit of ", own});
    const Point at{line.coordinate(1, {"x of ", own}), line.coordinate(2, {"y of ", own})};
    const double attribute = line.number(3, {"the attribute of ", own});
    const double area = line.fields() > 4 ? line.number(4, {"the area limit of ", own}) : -1;
    const double limit = area > 0 ? area : std::numeric_limits<double>::infinity();
    seeds.push_back({at, table.surface(attribute, limit)});
  }
  return seeds;
}

void expect_end(LineReader& line) {
  if (line.next()) {
    line.fail("something follows the last record", "remove it, or correct the numbers of records");
  }
}

fs::path with_extension(fs::path path, const char* extension) {
  return path.replace_extension(extension);
}

Vertices read_node_file(const fs::path& path, const std::string& asked_by) {
  std::error_code none;
  if (!fs::exists(path, none)) {
    throw InputError(asked_by, "the file with its vertices, " + path.string() + ", is missing",
                     "put it beside this file");
  }
  const TextFile file = read_text_file(path);
  LineReader line(file);
  Vertices vertices = read_vertices(line);
  expect_end(line);
  return vertices;
}

// The segments of X.poly beside X.ele. Its own vertices, if any, are those of X.node again.
std::vector<MarkedSegment> read_poly_segments(const fs::path& path, const Vertices& vertices) {
  const TextFile file = read_text_file(path);
  LineReader line(file);
  const Vertices own = read_vertices(line);
  if (!own.points.empty() && own.points != vertices.points) {
    throw InputError(file.name, "its vertices are not those of the .node file beside it",
                     "remove the file, or write both from the same mesh");
  }
  return read_segments(line, vertices, "segment");
}

std::vector<MarkedSegment> read_kept_edges(const fs::path& ele, const Vertices& vertices) {
  std::error_code none;
  const fs::path poly = with_extension(ele, ".poly");
  if (fs::exists(poly, none)) return read_poly_segments(poly, vertices);
  const fs::path edge = with_extension(ele, ".edge");
  if (!fs::exists(edge, none)) return {};
  const TextFile file = read_text_file(edge);
  LineReader line(file);
  std::vector<MarkedSegment> edges = read_segments(line, vertices, "edge");
  expect_end(line);
  std::erase_if(edges, [](const MarkedSegment& e) { return e.marker == 0; });
  return edges;
}

void read_triangles(LineReader& line, const Vertices& vertices, EntityTable& table,
                    TriangleSoup& soup) {
  line.need("the header of the triangles");
  line.expect_fields(1, 3, "triangles, nodes per triangle, attributes");
  const std::size_t count = line.count(0, "triangles", 8);
  const std::int64_t nodes = line.fields() > 1 ? line.integer(1, "nodes per triangle") : 3;
  if (nodes != 3) {
    line.fail(std::to_string(nodes) + " nodes per triangle: only 3 are supported",
              "export straight-sided triangles with 3 nodes");
  }
  const std::size_t attributes = line.fields() > 2 ? line.count(2, "attributes", 1) : 0;
  soup.triangles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!line.next()) line.ends_before(next_of("a triangle", i, count));
    const Record own{"triangle", vertices.base + static_cast<std::int64_t>(i)};
    check_number(line, line.integer(0, "the number of the triangle"), own);
    line.expect_fields(4 + attributes, 4 + attributes,
                       {"the number, three vertices and attributes of ", own});
    soup.triangles.push_back({vertex(line, 1, vertices, own), vertex(line, 2, vertices, own),
                              vertex(line, 3, vertices, own)});
    for (std::size_t k = 0; k < attributes; ++k) {
      const double attribute = line.number(4 + k, {"an attribute of ", own});
      if (k > 0) continue;
      soup.regions.push_back(table.surface(attribute, std::numeric_limits<double>::infinity()));
    }
  }
}

}  // namespace

Pslg read_poly(const fs::path& path) {
  const TextFile file = read_text_file(path);
  LineReader line(file);
  Vertices vertices = read_vertices(line);
  Pslg pslg;
  EntityTable table;
  if (file_kind(path) != ".node") {
    if (vertices.points.empty()) {
      vertices = read_node_file(with_extension(path, ".node"), line.where());
    }
    pslg.segments = on_curves(read_segments(line, vertices, "segment"), table);
    pslg.holes = read_holes(line);
    pslg.seeds = read_regions(line, table);
  }
  expect_end(line);
  pslg.points = std::move(vertices.points);
  pslg.base = vertices.base;
  pslg.entities = table.finish();
  pslg.source = file.name;
  return pslg;
}

TriangleSoup read_ele(const fs::path& path) {
  const TextFile file = read_text_file(path);
  Vertices vertices = read_node_file(with_extension(path, ".node"), file.name);
  TriangleSoup soup;
  EntityTable table;
  LineReader line(file);
  read_triangles(line, vertices, table, soup);
  expect_end(line);
  soup.segments = on_curves(read_kept_edges(path, vertices), table);
  soup.points = std::move(vertices.points);
  soup.base = vertices.base;
  soup.entities = table.finish();
  soup.source = file.name;
  return soup;
}

}  // namespace lepp
