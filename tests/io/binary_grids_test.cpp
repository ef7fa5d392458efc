// F32, STM, PGM, NPY: files of a short header and samples.

#include <doctest/doctest.h>

#include "io/grid_texts.hpp"

using namespace lepp;
using test::asc_head;
using test::bytes_of_values;
using test::contains;
using test::none;
using test::npy;
using test::read;
using test::refusal;
using test::same;

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
