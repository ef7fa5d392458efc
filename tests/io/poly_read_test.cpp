#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "io/scratch_folder.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/io/poly.hpp"

using namespace lepp;
using test::contains;
using test::error_of;
using test::ScratchFolder;

namespace {

const std::string square =
    "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 1\n1 1 2 7\n2 2 3 7\n3 3 4 0\n4 4 1 -8\n";

std::string poly_error(const std::string& text) {
  const ScratchFolder folder;
  const auto path = folder.put("a.poly", text);
  return error_of<InputError>([&] { read_poly(path); });
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST_CASE("a .poly file gives points, segments on curves by marker, holes and regions") {
  const ScratchFolder folder;
  const auto path = folder.put("a.poly", square + "1\n1 .5 .5\n2\n1 .1 .1 3 .25\n2 .9 .9 2.5\n");
  const Pslg pslg = read_poly(path);
  CHECK(pslg.points == std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  CHECK(pslg.base == 1);
  CHECK(pslg.source == path.string());
  REQUIRE(pslg.segments.size() == 4);
  CHECK(pslg.segments[3].a == VertexId(3U));
  CHECK(pslg.segments[3].b == VertexId(0U));
  CHECK(pslg.holes == std::vector<Point>{{0.5, 0.5}});
  REQUIRE(pslg.entities.curves.size() == 2);
  CHECK(pslg.segments[0].curve == pslg.segments[1].curve);
  CHECK(pslg.entities[*pslg.segments[0].curve].tag == 7);
  CHECK_FALSE(pslg.segments[2].curve.has_value());
  CHECK(pslg.entities[*pslg.segments[3].curve].tag == -8);
  REQUIRE(pslg.seeds.size() == 2);
  const auto& first = pslg.entities[pslg.seeds[0].surface];
  CHECK(first.tag == 3);
  CHECK(first.attribute == 3);
  CHECK(first.max_area == 0.25);
  const auto& second = pslg.entities[pslg.seeds[1].surface];
  CHECK(second.tag == 1);  // 2.5 is no tag: the smallest free one
  CHECK(second.attribute == 2.5);
  CHECK(second.max_area == std::numeric_limits<double>::infinity());
}

TEST_CASE("positive markers and attributes are physical groups, one per dimension and tag") {
  const ScratchFolder folder;
  const Pslg pslg = read_poly(
      folder.put("a.poly", square + "0\n3\n1 .1 .1 7 .25\n2 .9 .9 7 .5\n3 .2 .2 -4 -1\n"));
  const auto& groups = pslg.entities.groups;
  REQUIRE(groups.size() == 2);
  CHECK(groups[0].dimension == 1);
  CHECK(groups[0].tag == 7);
  CHECK(groups[1].dimension == 2);
  CHECK(groups[1].tag == 7);
  CHECK(pslg.entities.surfaces.size() == 3);  // two area limits of attribute 7
  CHECK(pslg.entities.surfaces[0].groups == pslg.entities.surfaces[1].groups);
  CHECK(pslg.entities.surfaces[2].groups.empty());
}

TEST_CASE("numbers may start at 0, and the same base is used in messages") {
  const ScratchFolder folder;
  const Pslg pslg = read_poly(folder.put(
      "a.poly", "3 2 1 1\n0 0 0 9.5 1\n1 1 0 9.5 1\n2 0 1 9.5\n3 0\n0 0 1\n1 1 2\n2 2 0\n0\n"));
  CHECK(pslg.base == 0);
  CHECK(pslg.segments[2].a == VertexId(2U));
  CHECK(contains(poly_error("3 2\n0 0 0\n1 1 0\n2 0 1\n1 0\n0 0 3\n0\n"),
                 "segment 0 refers to vertex 3, but the vertices are 0..2"));
}

TEST_CASE("a .poly file without vertices takes them from the .node file beside it") {
  const ScratchFolder folder;
  const auto path = folder.put("a.poly", "0 2 0 0\n1 0\n0 0 1\n0\n");
  CHECK(contains(error_of<InputError>([&] { read_poly(path); }), "a.node, is missing"));
  folder.put("a.node", "2 2 0 0\n0 5 6\n1 7 8\n");
  const Pslg pslg = read_poly(path);
  CHECK(pslg.points == std::vector<Point>{{5, 6}, {7, 8}});
  CHECK(pslg.base == 0);
  CHECK(read_poly(folder / "a.node").points == pslg.points);
}

TEST_CASE("a broken .poly file is refused with line and number") {
  const std::string good = square + "0\n";
  REQUIRE(poly_error(good).empty());
  CHECK(contains(poly_error(replaced(good, "3 1 1", "3 nan 1")), "line 4: x of vertex 3"));
  CHECK(contains(poly_error(replaced(good, "3 1 1", "3 1 inf")), "line 4: y of vertex 3"));
  CHECK(contains(poly_error(replaced(good, "3 1 1", "3 1e300 1")), "outside the supported range"));
  CHECK(contains(poly_error(replaced(good, "3 1 1", "3 1")), "has 2 fields"));
  CHECK(contains(poly_error(replaced(good, "3 1 1", "3 1 1 1")), "has 4 fields"));
  CHECK(contains(poly_error(replaced(good, "3 1 1", "5 1 1")), "vertex 5 stands where vertex 3"));
  CHECK(contains(poly_error(replaced(good, "4 2 0 0", "4 3 0 0")), "line 1: dimension 3"));
  CHECK(contains(poly_error(replaced(good, "4 2 0 0", "5 2 0 0")), "vertex 4 stands where"));
  CHECK(contains(poly_error(replaced(good, "4 2 0 0", "4294967299 2 0 0")), "4294967299 vertices"));
  CHECK(contains(poly_error(replaced(good, "4 2 0 0", "4 2 0 2")), "vertex markers is 2"));
  CHECK(contains(poly_error("4 2 4000000000 0\n0 0 0\n"), "4000000000 attributes"));
  CHECK(contains(poly_error("4 2 0 4000000000\n0 0 0\n"), "vertex markers is 4000000000"));
  CHECK(contains(poly_error(replaced(good, "2 2 3 7", "2 2 9 7")),
                 "line 8: segment 2 refers to vertex 9, but the vertices are 1..4"));
  CHECK(contains(poly_error(replaced(good, "2 2 3 7", "2 2 3 4294967296")), "beyond 32 bits"));
  CHECK(contains(poly_error(square), "the file ends where the number of holes should be"));
  CHECK(contains(poly_error(square + "1\n"), "announces 1 holes"));
  CHECK(contains(poly_error(good + "0\n1 2 3\n"), "something follows the last record"));
  CHECK(contains(poly_error(good + "GARBAGE 1 2 3\n"), "line 12"));
}

TEST_CASE("no prefix of a .poly file is taken for the whole, but those that only lack blanks") {
  const std::string good = square + "0\n";
  for (std::size_t n = 1; n + 2 < good.size(); ++n) {
    CAPTURE(n);
    CHECK_FALSE(poly_error(good.substr(0, n)).empty());
  }
}

TEST_CASE(".ele gives triangles with regions, and edges to keep from .poly or .edge") {
  const ScratchFolder folder;
  folder.put("a.node", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n");
  const auto path = folder.put("a.ele", "2 3 1\n1 1 2 3 5\n2 1 3 4 6\n");
  const TriangleSoup plain = read_ele(path);
  REQUIRE(plain.triangles.size() == 2);
  CHECK(plain.triangles[1] == std::array{VertexId(0U), VertexId(2U), VertexId(3U)});
  CHECK(plain.entities[plain.regions[0]].tag == 5);
  CHECK(plain.entities[plain.regions[1]].tag == 6);
  CHECK(plain.base == 1);
  CHECK(plain.segments.empty());
  folder.put("a.edge", "5 1\n1 1 2 3\n2 2 3 0\n3 3 4 0\n4 4 1 0\n5 1 3 0\n");
  const TriangleSoup with_edge = read_ele(path);
  REQUIRE(with_edge.segments.size() == 1);  // those with a marker
  CHECK(with_edge.entities[*with_edge.segments[0].curve].tag == 3);
  folder.put("a.poly", "0 2 0 0\n1 1\n1 1 3 0\n0\n");
  const TriangleSoup with_poly = read_ele(path);
  REQUIRE(with_poly.segments.size() == 1);
  CHECK(with_poly.segments[0].b == VertexId(2U));
  CHECK_FALSE(with_poly.segments[0].curve.has_value());
}

TEST_CASE("a broken .ele file is refused with line and number") {
  const ScratchFolder folder;
  const auto error = [&](const std::string& text) {
    const auto path = folder.put("a.ele", text);
    return error_of<InputError>([&] { read_ele(path); });
  };
  CHECK(contains(error("1 3 0\n1 1 2 3\n"), "a.node, is missing"));
  folder.put("a.node", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n");
  CHECK(error("1 3 0\n1 1 2 3\n").empty());
  CHECK(contains(error("2 3 0\n1 1 2 3\n2 1 3 9\n"),
                 "line 3: triangle 2 refers to vertex 9, but the vertices are 1..4"));
  CHECK(contains(error("1 6 0\n1 1 2 3 4 4 4\n"), "6 nodes per triangle"));
  CHECK(contains(error("1 3 1\n1 1 2 3\n"), "has 4 fields"));
  CHECK(contains(error("9 3 0\n1 1 2 3\n"), "announces 9 triangles"));
  folder.put("a.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 2\n0 0\n0\n");
  CHECK(contains(error("1 3 0\n1 1 2 3\n"), "not those of the .node file"));
}

TEST_CASE("the nasty .poly and .ele files are read, or refused by name") {
  const std::filesystem::path data = LEPP_TEST_DATA;
  const std::filesystem::path nasty = data / "nasty";
  if (data.empty() || !std::filesystem::exists(nasty)) {
    MESSAGE("skipped: LEPP_TEST_DATA has no folder nasty");
    return;
  }
  struct Row {
    const char* file;
    const char* message;
  };
  const Row rows[] = {
      {"p15_magnitude_1e300.poly", "line 3: x of vertex 2"},
      {"p17_nan_coordinate.poly", "line 4: x of vertex 3"},
      {"p19_zero_bytes.poly", "the file is empty"},
      {"p33_segment_index_out_of_range.poly",
       "segment 4 refers to vertex 8, but the vertices are "
       "1..4"},
      {"p39_count_2pow32plus3.poly", "line 1: announces 4294967299 vertices"},
      {"p41_dimension_3.poly", "line 1: dimension 3"},
      {"p53_extra_garbage_tail.poly", "line 13"},
      {"p55_denormal_near_collinear_constraint.poly", "vertex 5"},
      {"e01_index_out_of_range.ele", "triangle 2 refers to vertex 9, but the vertices are 1..4"},
      {"e05_ele_without_node.ele", "e05_ele_without_node.node, is missing"},
  };
  std::size_t readable = 0;
  for (const auto& entry : std::filesystem::directory_iterator(nasty)) {
    const auto path = entry.path();
    const bool is_poly = path.extension() == ".poly", is_ele = path.extension() == ".ele";
    if (!is_poly && !is_ele) continue;
    CAPTURE(path);
    const std::string error = error_of<InputError>([&] {
      if (is_poly) read_poly(path);
      else read_ele(path);
    });
    const auto row = std::ranges::find(rows, path.filename().string(), &Row::file);
    if (row == std::end(rows)) CHECK(error == "");
    else CHECK(contains(error, row->message));
    readable += error.empty() ? 1 : 0;
  }
  CHECK(readable >= 20);
}
