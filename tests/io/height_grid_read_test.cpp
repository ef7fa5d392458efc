#include "lepp/io/height_grid_read.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "io/scratch_folder.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/terrain/terrain_domain.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/random.hpp"
#include "support/real_inputs.hpp"
#include "terrain/coverage.hpp"

using namespace lepp;
using test::contains;
using test::error_of;
using test::ScratchFolder;

namespace {

template <class T>
std::string bytes_of_values(const std::vector<T>& values, bool big_endian) {
  std::string text;
  for (const T value : values) {
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &value, sizeof(T));
    if (big_endian != (std::endian::native == std::endian::big)) std::ranges::reverse(bytes);
    text += bytes;
  }
  return text;
}

std::string npy(const std::string& type, const std::string& order, const std::string& shape,
                const std::string& samples, int version = 1) {
  const std::string header =
      "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }\n";
  std::string text = "\x93NUMPY";
  text += {static_cast<char>(version), '\0', static_cast<char>(header.size()), '\0'};
  if (version > 1) text += std::string(2, '\0');
  return text + header + samples;
}

HeightGrid read(const std::string& name, const std::string& text,
                const HeightGridOptions& options = {}) {
  const ScratchFolder folder;
  return read_height_grid(folder.put(name, text), options);
}

std::string refusal(const std::string& name, const std::string& text) {
  return error_of<Error>([&] { read(name, text); });
}

const std::string asc_head = "ncols 3\nnrows 2\nxllcorner 10\nyllcorner 20\ncellsize 2\n";
constexpr double none = std::numeric_limits<double>::quiet_NaN();

bool same(const Heights& a, const std::vector<double>& b) {
  bool equal = a.size() == b.size();
  for (std::size_t i = 0; equal && i < b.size(); ++i)
    equal = a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i]));
  return equal;
}

}  // namespace

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

TEST_CASE("the nasty grids are refused or read as their list says") {
  const auto fate = [](const std::string& name) -> std::string {
    const auto path = test::real_input("nasty/" + name);
    if (!path) return "skipped";
    return error_of<InputError>([&] { read_height_grid(*path); });
  };
  if (!test::real_input("nasty/d01_all_nodata.asc")) return;
  CHECK(contains(fate("d01_all_nodata.asc"), "all 30 samples are without data"));
  CHECK(contains(fate("d03_one_cell.asc"), "1 x 1 samples has no area"));
  CHECK(contains(fate("d05_ragged_row.asc"), "holds 11 values, but its header says 12"));
  CHECK(contains(fate("d05_ragged_row.asc"), "line 8 is short"));
  CHECK(contains(fate("d07_cellsize_negative.asc"), "cellsize is -30"));
  CHECK(contains(fate("d09_dims_1e5x1e5.asc"), "holds 4 values, but its header says 10000000000"));
  CHECK(contains(fate("d15_too_many_values.asc"), "holds 12 values, but its header says 9"));
  CHECK(contains(fate("d17_negative_dims.asc"), "ncols is -20"));

  const HeightGrid centers =
      read_height_grid(*test::real_input("nasty/d11_utm_offset_llcenter.asc"));
  CHECK(centers.to_world({0, 0}) == Point{500015.5, 4649790.25});
  const HeightGrid oblong = read_height_grid(*test::real_input("nasty/d13_dx_dy.asc"));
  CHECK(oblong.step_x == 30);
  CHECK(oblong.step_y == -10);
}

TEST_CASE("F32: a line of text, then floats") {
  const std::string samples = bytes_of_values<float>({1, 2, -7, 4, NAN, 6.5F}, false);
  const HeightGrid grid = read("a.f32", "F32 3 2 -7\n" + samples);
  CHECK(same(grid.heights, {1, 2, none, 4, none, 6.5F}));
  CHECK(!grid.georeferenced);
  CHECK(grid.origin == Point{0, 1});
  CHECK(same(read("a.f32", "F32 3 2 nan\n" + samples).heights, {1, 2, -7, 4, none, 6.5F}));
  const HeightGrid sized = read("a", "F32 3 2 nan\n" + samples, {.cell = CellSize{30, 20}});
  CHECK(sized.step_x == 30);
  CHECK(sized.origin == Point{0, 20});
  CHECK(sized.aspect() == double(float(2.0 / 3)));
  CHECK(contains(refusal("a.f32", "F32 3 3 -7\n" + samples), "cut short"));
  CHECK(contains(refusal("a.f32", "F32 3 1 -7\n" + samples), "holds 24 bytes of samples"));
  CHECK(contains(refusal("a.f32", "F32 -3 2 -7\n" + samples), "columns is -3"));
  CHECK(contains(refusal("a.f32", "F32 1e9 1e9 -7\n" + samples), "columns is 1e+09"));
  CHECK(contains(refusal("a.f32", "F32 100000000 100000000 0\n" + samples), "cut short"));
  CHECK(contains(refusal("a.f32", "F32 3 2\n" + samples), "columns rows nodata"));
  const std::string infinite = bytes_of_values<float>({1, 2, 3, 4, -INFINITY, 6}, false);
  CHECK(contains(refusal("a.f32", "F32 3 2 -7\n" + infinite), "column 1, row 1"));
}

TEST_CASE("a declared value of no data beyond 1e30 also means its neighbours in seven digits") {
  const float lowest = std::numeric_limits<float>::lowest();
  const auto text = bytes_of_values<float>({1, 2, lowest, 4}, false);
  CHECK(same(read("a.f32", "F32 2 2 -3.402823e38\n" + text).heights, {1, 2, none, 4}));
  CHECK(same(read("a.f32", "F32 2 2 -3.4028235e38\n" + text).heights, {1, 2, none, 4}));
}

TEST_CASE("infinite heights are no heights if that is declared") {
  CHECK(same(read("a.asc", asc_head + "NODATA_value inf\n1 2 3\n4 inf 6\n").heights,
             {1, 2, 3, 4, none, 6}));
  const auto floats = bytes_of_values<float>({1, 2, -INFINITY, 4}, false);
  CHECK(same(read("a.f32", "F32 2 2 -inf\n" + floats).heights, {1, 2, none, 4}));
  const auto wide = bytes_of_values<double>({1, 2, -INFINITY, 4}, false);
  const HeightGridOptions declared{.nodata = -INFINITY};
  const HeightGrid grid = read("a.npy", npy("<f8", "False", "(2, 2)", wide), declared);
  CHECK(same(grid.heights, {1, 2, none, 4}));
  CHECK(grid.heights.are_floats());
}

TEST_CASE("STM in both byte orders") {
  for (const bool big : {true, false}) {
    CAPTURE(big);
    const std::string order = big ? "\4\3\2\1" : "\1\2\3\4";
    const std::string samples = bytes_of_values<std::uint16_t>({1, 2, 300, 65535}, big);
    CHECK(same(read("a.stm", "STM 2 2 " + order + "\n" + samples).heights, {1, 2, 300, 65535}));
  }
  CHECK(contains(refusal("a.stm", "STM 2 2 \n"), "four bytes 4 3 2 1"));
  CHECK(contains(refusal("a.stm", "stm"), "does not begin as a .stm"));
}

TEST_CASE("PGM, plain and raw, of one and two bytes, with comments") {
  const std::string wide = bytes_of_values<std::uint16_t>({1, 2, 300, 65535}, true);
  CHECK(same(read("a.pgm", "P5\n# a\n2 2 # b\n65535\n" + wide).heights, {1, 2, 300, 65535}));
  CHECK(same(read("a.pgm", std::string("P5 2 2 255\n\1\2\3\377")).heights, {1, 2, 3, 255}));
  CHECK(same(read("a.pgm", "P2\n#\n2 2\n999\n1 2 # x 7\n300 4\n").heights, {1, 2, 300, 4}));
  CHECK(contains(refusal("a.pgm", "P5 2 2 255\n\1\2\3"), "holds 3 bytes"));
  CHECK(contains(refusal("a.pgm", "P2 2 2 255\n1 2 3"), "holds 3 values"));
  CHECK(contains(refusal("a.pgm", "P5 2 2 70000\n"), "largest value"));
}

TEST_CASE("NPY: types, byte orders, C and Fortran order, versions") {
  const std::vector<double> rows = {1, 2, 3, 4, 5, 6};
  for (const bool big : {true, false}) {
    CAPTURE(big);
    const std::string order = big ? ">" : "<";
    const auto agrees = [&]<class T>(const std::string& type, T) {
      const std::vector<T> by_row = {1, 2, 3, 4, 5, 6}, by_column = {1, 4, 2, 5, 3, 6};
      const std::string c = npy(order + type, "False", "(2, 3)", bytes_of_values(by_row, big));
      const std::string f = npy(order + type, "True", "(2, 3)", bytes_of_values(by_column, big), 2);
      CHECK(same(read("a.npy", c).heights, rows));
      CHECK(same(read("a.npy", f).heights, rows));
    };
    agrees("f4", float{});
    agrees("f8", double{});
    agrees("i2", std::int16_t{});
    agrees("u2", std::uint16_t{});
    agrees("i4", std::int32_t{});
    agrees("u4", std::uint32_t{});
    agrees("i8", std::int64_t{});
    agrees("u8", std::uint64_t{});
  }
  CHECK(same(read("a.npy", npy("|u1", "False", "(3, 2)", "\1\2\3\4\5\6", 3)).heights, rows));
}

TEST_CASE("NPY: every height is the one of the file, in both orders, whatever its type") {
  const auto agrees = [&]<class T>(const std::string& type, const std::vector<T>& values,
                                   const std::vector<double>& heights) {
    CAPTURE(type);
    const std::string c = npy(type, "False", "(2, 2)", bytes_of_values(values, false));
    CHECK(same(read("a.npy", c).heights, heights));
    const std::string f = npy(type, "True", "(2, 2)", bytes_of_values(values, false));
    CHECK(same(read("a.npy", f).heights, {heights[0], heights[2], heights[1], heights[3]}));
    CHECK(!read("a.npy", f).heights.are_floats());
  };
  const double fine = 1e6 + 1e-6, tiny = 5e-324;
  agrees("<f8", std::vector<double>{1, fine, NAN, tiny}, {1, fine, none, tiny});
  agrees("<i4", std::vector<std::int32_t>{1, 16777217, INT32_MIN, INT32_MAX},
         {1, 16777217, -2147483648.0, 2147483647});
  agrees("<u4", std::vector<std::uint32_t>{1, 16777217, 0, UINT32_MAX},
         {1, 16777217, 0, 4294967295});
  agrees("<i8", std::vector<std::int64_t>{1, 16777217, -(1LL << 53), 1LL << 53},
         {1, 16777217, -0x1p53, 0x1p53});
  const auto large = bytes_of_values<std::int64_t>({1, 2, (1LL << 53) + 1, 4}, false);
  const std::string too_large = refusal("a.npy", npy("<i8", "False", "(2, 2)", large));
  CHECK(contains(too_large, "column 0, row 1"));
  CHECK(contains(too_large, "more than 53 bits"));
}

TEST_CASE("no data is compared in the file's own type: values beside it are heights") {
  const auto read_as = [&]<class T>(const std::string& type, const std::vector<T>& values,
                                    double nodata) {
    return read("a.npy", npy(type, "False", "(2, 2)", bytes_of_values(values, false)),
                {.nodata = nodata})
        .heights;
  };
  CHECK(same(read_as("<i4", std::vector<std::int32_t>{16777216, 16777217, 1, 1}, 16777217),
             {16777216, none, 1, 1}));
  CHECK(same(read_as("<i8", std::vector<std::int64_t>{INT64_MIN, 2, 1, 1}, -0x1p63),
             {none, 2, 1, 1}));
  const std::vector<double> doubles = {0.1, 0.1F, 1e-60, 0};
  CHECK(same(read_as("<f8", doubles, 0.1), {none, 0.1F, 1e-60, 0}));
  CHECK(same(read_as("<f8", doubles, 0), {0.1, 0.1F, 1e-60, none}));
  CHECK(same(read_as("<f4", std::vector<float>{0.1F, 0.2F, 1, 0}, 0.1), {none, 0.2F, 1, 0}));
  const double lowest = std::numeric_limits<float>::lowest();
  CHECK(same(read_as("<f8", std::vector<double>{1, lowest, 1e30, 1}, -3.402823e38),
             {1, none, 1e30, 1}));
}

TEST_CASE("an NPY header that makes no sense is refused") {
  CHECK(contains(refusal("a.npy", npy("<c8", "False", "(1, 1)", "12345678")), "type \"<c8\""));
  CHECK(contains(refusal("a.npy", npy("|u1", "False", "(4,)", "1234")), "1 dimensions"));
  CHECK(contains(refusal("a.npy", npy("|u1", "False", "(1, 2, 2)", "1234")), "3 dimensions"));
  CHECK(contains(refusal("a.npy", npy("|u1", "Maybe", "(2, 2)", "1234")), "fortran_order"));
  CHECK(contains(refusal("a.npy", npy("|u1", "False", "(2, 3)", "1234")), "cut short"));
  CHECK(
      contains(refusal("a.npy", npy("|u1", "False", "(99999999, 99999999)", "1234")), "cut short"));
  CHECK(contains(refusal("a.npy", npy("|u1", "False", "(2, 2)", "1234", 9)), "version 9"));
  CHECK(contains(refusal("a.npy", "\x93NUMPY\1"), "header is longer"));
  const auto infinite = bytes_of_values<double>({1, 2, 1e300, 4}, false);
  CHECK(contains(refusal("a.npy", npy("<f8", "True", "(2, 2)", infinite)), "column 1, row 0"));
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

TEST_CASE("real grids have the size and the range that their list gives") {
  struct Known {
    const char* name;
    std::uint32_t columns, rows;
    double low, high;
    std::size_t without;
  };
  for (const Known& known :
       {Known{"ashby.stm", 346, 452, 113, 587, 0}, Known{"crater.stm", 336, 459, 1533, 2478, 0},
        Known{"jacksboro.npy", 403, 344, 236, 1076, 0},
        Known{"landlab_tidal_zSW3.asc", 300, 452, -2.609, 8.461, 35152},
        Known{"landlab_hugo_site.asc", 76, 55, 1660, 1711, 2028}}) {
    CAPTURE(known.name);
    const auto path = test::real_input(std::string("dem/") + known.name);
    if (!path) continue;
    const HeightGrid grid = read_height_grid(*path);
    CHECK(grid.columns == known.columns);
    CHECK(grid.rows == known.rows);
    double low = INFINITY, high = -INFINITY;
    std::size_t without = 0;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const double h = grid.heights[i];
      without += std::isnan(h);
      low = std::fmin(low, h);
      high = std::fmax(high, h);
    }
    CHECK(low == doctest::Approx(known.low).epsilon(1e-3));
    CHECK(high == doctest::Approx(known.high).epsilon(1e-3));
    CHECK(without == known.without);
  }
}

TEST_CASE("of real grids with gaps the domain loses no sample and covers none without data") {
  struct Known {
    const char* name;
    std::size_t corners;
  };
  for (const Known& known :
       {Known{"dem/landlab_tidal_zSW3.asc", 100}, Known{"dem/landlab_hugo_site.asc", 100},
        Known{"nasty/d11_utm_offset_llcenter.asc", 4}}) {
    CAPTURE(known.name);
    const auto path = test::real_input(known.name);
    if (!path) continue;
    const HeightGrid grid = read_height_grid(*path);
    const TerrainDomain domain = terrain_domain(grid);
    CHECK(domain.pslg.points.size() <= known.corners);
    const auto found = test::coverage(grid, constrained_delaunay(domain.pslg).mesh);
    CHECK(found.lost == 0);
    CHECK(found.covered == 0);
  }
}
