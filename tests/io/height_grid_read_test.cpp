#include "lepp/io/height_grid_read.hpp"

#include <doctest/doctest.h>

#include <tuple>

#include "io/grid_texts.hpp"
#include "support/random.hpp"

using namespace lepp;
using test::asc_head;
using test::bytes_of_values;
using test::contains;
using test::error_of;
using test::none;
using test::npy;
using test::read;
using test::refusal;
using test::same;
using test::ScratchFolder;

TEST_CASE("an ESRI ASCII grid: samples are pixel centers, row 0 is the northern one") {
  const HeightGrid grid = read("a.asc", asc_head + "NODATA_value -1\n1 2 3\n4 -1 6.5\n");
  CHECK(grid.columns == 3);
  CHECK(grid.rows == 2);
  CHECK(grid.origin == Point{11, 23});
  CHECK(grid.step_x == 2);
  CHECK(grid.step_y == -2);
  CHECK(grid.georeferenced);
  CHECK(!grid.degrees);
  CHECK(same(grid.heights, {1, 2, 3, 4, none, 6.5F}));
  CHECK(grid.heights.are_floats());
  CHECK(grid.to_world(grid.sample(2, 0)) == Point{15, 21});
  CHECK(grid.to_grid({15, 21}) == Point{2, 0});
}

TEST_CASE("keys of an ESRI ASCII grid in any case and order; CRLF; dx and dy; wrapped rows") {
  const HeightGrid grid = read("a.asc",
                               "DX 2\r\nDY 1\r\nNROWS 2\r\nNCols 3\r\nyllcenter 5\r\n"
                               "XLLCENTER 4\r\n1 2\r\n3\r\n4 5 6");
  CHECK(grid.origin == Point{4, 6});
  CHECK(grid.cell_width == 2);
  CHECK(grid.cell_height == 1);
  CHECK(same(grid.heights, {1, 2, 3, 4, 5, 6}));
  CHECK(same(read("a.asc", asc_head + "1 2 3 4 5 6").heights, {1, 2, 3, 4, 5, 6}));
  CHECK(same(read("a.asc", asc_head + "1 2 +3 4 nan -9999\n").heights, {1, 2, 3, 4, none, none}));
}

TEST_CASE("heights of text are kept as they are written, as doubles from the first one on") {
  const HeightGrid grid = read("a.asc", asc_head + "1 2 -9999 4 1000000.000001 0.1\n");
  CHECK(!grid.heights.are_floats());
  CHECK(same(grid.heights, {1, 2, none, 4, 1000000.000001, 0.1}));
  CHECK(read("a.asc", asc_head + "1 2 -9999 4 0.5 16777218\n").heights.are_floats());
  CHECK(
      same(read("a.asc", asc_head + "1 2 3 4 1e39 1e-310\n").heights, {1, 2, 3, 4, 1e39, 1e-310}));
}

TEST_CASE("what is wrong with an ESRI ASCII grid is named, with its line") {
  CHECK(contains(refusal("a.asc", asc_head + "1 2 3\n4 5\n"), "holds 5 values"));
  CHECK(contains(refusal("a.asc", asc_head + "1 2 3\n4 5\n"), "line 7 is short, with 2 values"));
  CHECK(contains(refusal("a.asc", asc_head + "1 2 3\n4 5 6 7\n"), "line 7 has 4 values"));
  CHECK(contains(refusal("a.asc", asc_head + "1 2\n3 4 5 6\n"), "line 6 is short"));
  CHECK(contains(refusal("a.asc", asc_head + "1 2 3\n4 5 x\n"), "a.asc, line 7: \"x\""));
  CHECK(contains(refusal("a.asc", asc_head + "1 2 3\n4 5 1,5\n"), "decimal point"));
  CHECK(contains(refusal("a.asc", asc_head + "1 2 3\n4 inf 6\n"), "line 7, column 1, row 1"));
  CHECK(contains(refusal("a.asc", asc_head + "1 2 3\n4 1e61 6\n"), "larger than 1.6e60"));
  CHECK(contains(refusal("a.asc", asc_head + "1 2 3\n4 1e999 6\n"), "infinite"));
  CHECK(contains(refusal("a.asc", asc_head), "no heights"));
  CHECK(
      contains(refusal("a.asc", asc_head + "cellsize 2\n1 2 3 4 5 6"), "line 6: cellsize occurs"));
  CHECK(contains(refusal("a.asc", asc_head + "dx 2\n1 2 3 4 5 6"), "cellsize and dx"));
  CHECK(contains(refusal("a.asc", "ncols 3\nnrows 2\ndx 1\nxllcorner 0\nyllcorner 0\n1 2 3 4 5 6"),
                 "dy is missing"));
  CHECK(contains(refusal("a.asc", "ncols 3\nnrowz 2\n"), "\"nrowz\" is no key"));
  CHECK(contains(refusal("a.asc", "hello"), "no key"));
  CHECK(contains(refusal("a.asc", ""), "empty"));
}

TEST_CASE("a window is the same as that part of the whole grid, in every form") {
  const ScratchFolder folder;
  const std::vector<std::uint16_t> values = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  const std::vector<std::uint16_t> by_column = {1, 5, 9, 2, 6, 10, 3, 7, 11, 4, 8, 12};
  const std::vector<float> floats(values.begin(), values.end());
  const std::string big = bytes_of_values(values, true);
  const std::vector<std::filesystem::path> files = {
      folder.put("a.f32", "F32 4 3 nan\n" + bytes_of_values(floats, false)),
      folder.put("a.npy", npy(">u2", "False", "(3, 4)", big)),
      folder.put("b.npy", npy("<u2", "True", "(3, 4)", bytes_of_values(by_column, false))),
      folder.put("a.stm", "STM 4 3 \4\3\2\1\n" + big),
      folder.put("a.pgm", "P5 4 3 65535\n" + big),
      folder.put("b.pgm", "P2 4 3 65535\n1 2 3 4 5 6 7 8 9 10 11 12"),
      folder.put("a.asc",
                 "ncols 4 nrows 3 xllcenter 0 yllcenter 0 cellsize 1\n"
                 "1 2 3 4 5 6 7 8 9 10 11 12")};
  for (const auto& file : files) {
    CAPTURE(file.string());
    const HeightGrid header = read_height_grid_header(file);
    CHECK(header.columns == 4);
    CHECK(header.rows == 3);
    CHECK(header.heights.empty());
    const HeightGrid part = read_height_window(file, {1, 1, 2, 2});
    CHECK(same(part.heights, {6, 7, 10, 11}));
    CHECK(part.origin == Point{1, 1});
    CHECK(same(read_height_window(file, {0, 2, 4, 1}).heights, {9, 10, 11, 12}));
    CHECK(error_of<InputError>([&] { read_height_window(file, {3, 0, 2, 1}); }) != "");
    CHECK(error_of<InputError>([&] { read_height_window(file, {0, 0, 1, 0}); }) != "");
  }
}

TEST_CASE(
    "a damaged file is read or refused, and never takes more memory than four times its size") {
  constexpr std::uint64_t seed = 9;
  CAPTURE(seed);
  test::Random random(seed);
  const std::string wide = bytes_of_values<std::uint16_t>({1, 2, 3, 4, 5, 6}, true);
  const std::vector<std::string> files = {
      asc_head + "NODATA_value -1\n1 2 3\n4 -1 6.5\n",
      "F32 3 2 nan\n" + bytes_of_values<float>({1, 2, 3, 4, 5, 6}, false),
      "STM 3 2 \4\3\2\1\n" + wide,
      "P5 # a\n3 2 65535\n" + wide,
      "P2 # a\n3 2 65535\n1 2 3 4 5 6\n",
      npy("<u2", "True", "(2, 3)", wide),
      npy("|u1", "False", "(2, 3)", "123456", 2)};
  const ScratchFolder folder;
  std::size_t refused = 0, taken = 0;
  for (int i = 0; i < 1500; ++i) {
    CAPTURE(i);
    std::string text = files[static_cast<std::size_t>(i) % files.size()];
    for (int k = random.between(1, 4); k > 0; --k) {
      const std::size_t at = random.below(static_cast<std::uint32_t>(text.size()));
      const std::string digits = "0123456789-e.\n ";
      if (random.one_in(2)) text[at] = digits[random.below(15)];
      else if (random.one_in(3)) text.insert(at, 1, digits[random.below(15)]);
      else if (random.one_in(2)) text.erase(at, 1 + random.below(4));
      else text[at] = static_cast<char>(random.below(256));
      if (text.empty()) text = "0";
    }
    try {
      // Files that no longer begin as one of these would go to lepp-gdal.
      HeightGridOptions options;
      options.gdal.helper = folder / "nothing";
      const HeightGrid grid = read_height_grid(folder.put("a.asc", text), options);
      ++taken;
      REQUIRE(grid.heights.size() == grid.size());
      REQUIRE(grid.heights.bytes() <= 4 * text.size());
    } catch (const Error&) {
      ++refused;
    }
  }
  CHECK(refused > 300);
  CHECK(taken > 100);
}

TEST_CASE("a part of a grid knows what lies around it, at sides and corners of the whole too") {
  const ScratchFolder folder;
  const auto path = folder.put("a.asc",
                               "ncols 4 nrows 3 xllcenter 0 yllcenter 0 cellsize 1\n"
                               "1 2 3 4 5 -9999 7 8 9 10 11 12");
  const HeightGrid whole = read_height_grid_header(path);
  const GridPart inner = read_grid_part(path, whole, {2, 0, 1, 2});
  CHECK(same(inner.grid.heights, {3, 7}));
  CHECK(inner.grid.origin == Point{2, 2});
  CHECK(inner.north.empty());
  CHECK(inner.south == std::vector<bool>{true, true, true});
  CHECK(inner.west == std::vector<bool>{false, true});  // from the south
  CHECK(inner.east == std::vector<bool>{true, true});
  const GridPart all = read_grid_part(path, whole, {0, 0, 4, 3});
  CHECK(all.grid.heights.size() == 12);
  CHECK((all.west.empty() && all.east.empty() && all.south.empty() && all.north.empty()));
  CHECK(error_of<InputError>([&] { read_grid_part(path, whole, {3, 0, 2, 3}); }) != "");
}

TEST_CASE("an ESRI ASCII grid in degrees, as the .prj beside it says, has cells in metres") {
  const ScratchFolder folder;
  folder.put("a.prj", "GEOGCS[\"WGS 84\"]\n");
  const auto path = folder.put("a.asc",
                               "ncols 2\nnrows 3\nxllcenter 7\nyllcenter 44\ncellsize 1\n"
                               "1 2\n3 4\n5 6\n");
  const HeightGrid grid = read_height_grid(path);
  CHECK(grid.degrees);
  CHECK(grid.crs == "GEOGCS[\"WGS 84\"]");
  // A degree at 45 degrees north, as tables give it.
  CHECK(grid.cell_width == doctest::Approx(78846.8).epsilon(1e-5));
  CHECK(grid.cell_height == doctest::Approx(111131.7).epsilon(1e-5));
  const HeightGrid part = read_height_window(path, {0, 0, 2, 1});
  CHECK(part.cell_width == grid.cell_width);
}

TEST_CASE("an ESRI ASCII grid in other angles than degrees is taken as it is, with a warning") {
  const ScratchFolder folder;
  folder.put("a.prj", R"(GEOGCS["x",PRIMEM["Paris",2.33],UNIT["grad",0.0157079632679489]])");
  const HeightGrid grid = read_height_grid(folder.put("a.asc", asc_head + "1 2 3 4 5 6"));
  CHECK(!grid.degrees);
  CHECK(grid.cell_width == 2);
  REQUIRE(grid.warnings.size() == 1);
  CHECK(contains(grid.warnings[0], "not in degrees"));
}

TEST_CASE("heights of more than the machine's memory are refused in every form, with what to do") {
  const ScratchFolder folder;
  const std::string size = "1500000";  // squared, and times 4: 9 TB, of which nothing is written
  for (const auto& [name, head, sample] :
       {std::tuple("a.f32", "F32 " + size + " " + size + " nan\n", 4),
        std::tuple("a.stm", "STM " + size + " " + size + " \4\3\2\1\n", 2),
        std::tuple(
            "a.asc",
            "ncols " + size + "\nnrows " + size + "\nxllcenter 0\nyllcenter 0\ncellsize 1\n1 ",
            4)}) {
    CAPTURE(name);
    const auto path = folder.put(name, head);
    std::error_code error;
    std::filesystem::resize_file(path, head.size() + 2'250'000'000'000ULL * sample, error);
    if (error) {
      MESSAGE("skipped: no sparse files of terabytes here");
      return;
    }
    const std::string message = error_of<RefusedError>([&] { read_height_grid(path); });
    CHECK(contains(message, name));
    CHECK(contains(message, "more than this machine has"));
    CHECK(contains(message, "--tiles"));
  }
  CHECK(read_height_window(folder / "a.f32", {7, 7, 1, 1}).heights[0] == 0);
}
