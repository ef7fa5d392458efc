// What lepp-gdal makes of values: types, scales, masks and no data. Only built where GDAL is.

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>

#include "io/gdal_rasters.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/geometry/text.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

// "1 2 - 4": - where there is no data.
std::string shown(const HeightGrid& grid) {
  std::string text;
  for (const double h : values_of(grid)) {
    if (!text.empty()) text += ' ';
    text += std::isnan(h) ? "-" : to_text(h);
  }
  return text;
}

}  // namespace

TEST_CASE("GDAL: no data by declaration, by NaN, and by a double that the floats are nearest to") {
  const auto without = [](const HeightGrid& grid) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      if (std::isnan(grid.heights[i])) found.push_back(i);
    }
    return found;
  };
  using Places = std::vector<std::size_t>;
  const auto nodata = [](const std::string& value) {
    return "<NoDataValue>" + value + "</NoDataValue>";
  };
  CHECK(without(read_values<std::int16_t>("Int16", {1, -99, 3, 4, 5, -99}, nodata("-99"))) ==
        Places{1, 5});
  CHECK(without(read_values<float>("Float32", {1, NAN, 0.1F, 4, 5, 6}, nodata("0.1"))) ==
        Places{1, 2});
  CHECK(without(read_values<float>("Float32", {1, 2, -3.4028235e38F, 4, 5, 6},
                                   nodata("-3.402823e38"))) == Places{2});
  CHECK(without(read_values<double>("Float64", {1, 2, -1e300, 4, NAN, 6}, nodata("-1e300"))) ==
        Places{2, 4});
  const HeightGridOptions asked{.nodata = 4};
  CHECK(without(read_values<float>("Float32", {1, 2, 3, 4, 5, 6}, nodata("5"), north_up, asked)) ==
        Places{3});
}

TEST_CASE("GDAL: masks are applied: of a band, of the data set, and its values of no data") {
  const auto heights = [](const std::string& georeference, const std::string& band,
                          std::optional<double> nodata = {}) {
    const ScratchFolder folder;
    folder.put("data.bin", bytes_of_values<std::int16_t>({1, 2, 3, 4, 5, 6}));
    folder.put("mask.bin", std::string("\377\0\1\377\377\0", 6));
    const auto path = folder.put("a.vrt", vrt("Int16", 2, georeference, band));
    return shown(read_height_grid(path, {.nodata = nodata}));
  };
  const std::string mask =
      "<MaskBand><VRTRasterBand dataType=\"Byte\" subClass=\"VRTRawRasterBand\">"
      "<SourceFilename relativeToVRT=\"1\">mask.bin</SourceFilename><ImageOffset>0</ImageOffset>"
      "<PixelOffset>1</PixelOffset><LineOffset>3</LineOffset></VRTRasterBand></MaskBand>";
  const std::string nodata = "<NoDataValue>4</NoDataValue>";
  const std::string values = "<Metadata><MDI key=\"NODATA_VALUES\">4</MDI></Metadata>";
  CHECK(heights(north_up, "") == "1 2 3 4 5 6");
  CHECK(heights(north_up, mask) == "1 - 3 4 5 -");
  CHECK(heights(north_up + mask, "") == "1 - 3 4 5 -");
  CHECK(heights(north_up, nodata + mask) == "1 - 3 - 5 -");
  CHECK(heights(north_up + values, "") == "1 2 3 - 5 6");
  CHECK(heights(north_up + values, "", 5) == "1 2 3 4 - 6");
}

TEST_CASE("GDAL: scale and offset are applied, to the last digit") {
  const auto scaled = [](const std::string& scale) {
    return read_values<std::int16_t>(
               "Int16", {1, 2, -9, 4, 5, 6},
               "<NoDataValue>-9</NoDataValue><Offset>100</Offset><Scale>" + scale + "</Scale>")
        .heights;
  };
  CHECK(scaled("0.5")[1] == 101);
  CHECK(std::isnan(scaled("0.5")[2]));
  CHECK(scaled("0.5").are_floats());
  CHECK(scaled("0.1")[5] == 6 * 0.1 + 100);
  CHECK(read_values<float>("Float32", {1, 2, 3, 4, 5, 0.1F}, "<Scale>0.1</Scale>").heights[5] ==
        0.1F * 0.1);
}

TEST_CASE("GDAL: of a scaled band, no data is a value of the file, and a warning says so") {
  const std::string scaled = "<Offset>100</Offset><Scale>0.1</Scale>";
  const auto grid = [&](double nodata, const std::string& band) {
    return read_values<std::int16_t>("Int16", {1, 2, -9999, 4, 5, 6}, band, north_up,
                                     {.nodata = nodata});
  };
  CHECK(std::isnan(grid(-9999, scaled).heights[2]));
  CHECK(grid(-899.9, scaled).heights[2] == doctest::Approx(-899.9));
  REQUIRE(grid(-899.9, scaled).warnings.size() == 1);
  CHECK(contains(grid(-899.9, scaled).warnings[0], "before its scale of 0.1 and offset of 100"));
  CHECK(grid(-9999, "").warnings.empty());
}

TEST_CASE("GDAL: heights of every type are those of the file") {
  const auto agrees = []<class T>(const std::string& type, const std::vector<T>& values,
                                  const std::string& band = "") {
    CAPTURE(type);
    const std::vector<double> heights(values.begin(), values.end());
    const HeightGrid grid = read_values<T>(type, values, band);
    CHECK(values_of(grid) == heights);
    CHECK(grid.heights.are_floats() == (heights.back() == 7));
  };
  agrees("Byte", std::vector<std::uint8_t>{0, 1, 2, 3, 255, 7});
  agrees("UInt16", std::vector<std::uint16_t>{0, 1, 2, 3, 65535, 7});
  agrees("Int16", std::vector<std::int16_t>{0, 1, 2, 3, -32768, 7});
  agrees("Int32", std::vector<std::int32_t>{0, 1, INT32_MIN, INT32_MAX, 16777216, 16777217},
         "<NoDataValue>16777218</NoDataValue>");
  agrees("UInt32", std::vector<std::uint32_t>{0, 1, 2, UINT32_MAX, 16777216, 16777217});
  agrees("Int64", std::vector<std::int64_t>{0, 1, 2, 1LL << 53, -(1LL << 53), (1LL << 40) + 1});
  agrees("UInt64", std::vector<std::uint64_t>{0, 1, 2, 3, 1ULL << 53, (1ULL << 40) + 1});
  agrees("Float32", std::vector<float>{0.1F, 1e-45F, 3e38F, 3, 4, 7});
  agrees("Float64", std::vector<double>{1, 2, 3, 4, 16777216, 7});
  agrees("Float64", std::vector<double>{1, 2, 1e60, 5e-324, 0.1, 1e6 + 1e-6},
         "<NoDataValue>1000000</NoDataValue>");
  const std::string message = error_of<InputError>([&] {
    read_values<std::int64_t>("Int64", {1, 2, 3, 4, (1LL << 53) + 1, 6}, "");
  });
  CHECK(contains(message, "column 1, row 1"));
  CHECK(contains(message, "more than 53 bits"));
  CHECK(std::isnan(read_values<std::int64_t>("Int64", {1, INT64_MAX, 3, 4, 5, 6},
                                             "<NoDataValue>9223372036854775807</NoDataValue>")
                       .heights[1]));
}

TEST_CASE("GDAL: an infinite height is refused, with its place") {
  const auto message = [](double height) {
    return error_of<InputError>([&] {
      read_values<double>("Float64", {1, 2, 3, 4, height, 6}, "");
    });
  };
  CHECK(contains(message(INFINITY), "column 1, row 1"));
  CHECK(contains(message(1e61), "column 1, row 1"));
}
