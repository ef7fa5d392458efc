#include "lepp/io/gdal_process.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "io/scratch_folder.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/io/height_grid_read.hpp"
#include "support/real_inputs.hpp"

// Only built where GDAL is. Rasters of our own are VRT files: a header over bytes.

using namespace lepp;
using test::contains;
using test::error_of;
using test::ScratchFolder;

namespace {

/// A raster of 3 x 2 over the bytes in "data.bin".
std::string vrt(const std::string& type, int bytes, const std::string& georeference,
                const std::string& band) {
  const std::string pixel = std::to_string(bytes), line = std::to_string(3 * bytes);
  return "<VRTDataset rasterXSize=\"3\" rasterYSize=\"2\">" + georeference +
         "<VRTRasterBand dataType=\"" + type + "\" band=\"1\" subClass=\"VRTRawRasterBand\">" +
         band + "<SourceFilename relativeToVRT=\"1\">data.bin</SourceFilename>" +
         "<ImageOffset>0</ImageOffset><PixelOffset>" + pixel + "</PixelOffset><LineOffset>" + line +
         "</LineOffset><ByteOrder>LSB</ByteOrder></VRTRasterBand></VRTDataset>";
}

template <class T>
std::string bytes_of_values(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

const std::string north_up = "<GeoTransform>100, 10, 0, 50, 0, -5</GeoTransform>";

template <class T>
HeightGrid read(const std::string& type, const std::vector<T>& values, const std::string& band,
                const std::string& georeference = north_up, const HeightGridOptions& options = {}) {
  const ScratchFolder folder;
  folder.put("data.bin", bytes_of_values(values));
  return read_height_grid(folder.put("a.vrt", vrt(type, sizeof(T), georeference, band)), options);
}

std::vector<double> values_of(const HeightGrid& grid) {
  std::vector<double> values;
  for (std::size_t i = 0; i < grid.heights.size(); ++i) values.push_back(grid.heights[i]);
  return values;
}

// "1 2 - 4": - where there is no data.
std::string shown(const HeightGrid& grid) {
  std::string text;
  for (const double h : values_of(grid)) {
    if (!text.empty()) text += ' ';
    text += std::isnan(h) ? "-" : to_text(h);
  }
  return text;
}

std::string refusal(const std::string& georeference) {
  return error_of<InputError>([&] {
    read<float>("Float32", {1, 2, 3, 4, 5, 6}, "", georeference);
  });
}

}  // namespace

TEST_CASE("GDAL: a north-up raster, its samples in the middle of pixels") {
  const HeightGrid grid = read<float>("Float32", {1, 2, 3, 4, 5, 6}, "");
  CHECK(values_of(grid) == std::vector<double>{1, 2, 3, 4, 5, 6});
  CHECK(grid.heights.are_floats());
  CHECK(grid.georeferenced);
  CHECK(grid.origin == Point{105, 47.5});
  REQUIRE(grid.files.size() == 2);  // what is written must not replace either
  CHECK(grid.files[0].ends_with("a.vrt"));
  CHECK(grid.files[1].ends_with("data.bin"));
  CHECK(grid.step_x == 10);
  CHECK(grid.step_y == -5);
  CHECK(grid.cell_height == 5);
  CHECK(grid.to_grid({105, 42.5}) == Point{0, 0});
}

TEST_CASE("GDAL: a south-up raster has its first row in the south") {
  const HeightGrid grid = read<float>("Float32", {1, 2, 3, 4, 5, 6}, "",
                                      "<GeoTransform>100, 10, 0, 50, 0, 5</GeoTransform>");
  CHECK(!grid.north_first());
  CHECK(grid.origin == Point{105, 52.5});
  CHECK(grid.to_grid({105, 52.5}) == Point{0, 0});
}

TEST_CASE("GDAL: rotated and mirrored rasters are refused") {
  CHECK(contains(refusal("<GeoTransform>0, 1, 0.1, 0, 0.1, -1</GeoTransform>"), "rotated"));
  CHECK(contains(refusal("<GeoTransform>0, -1, 0, 0, 0, -1</GeoTransform>"), "west to east"));
}

TEST_CASE("GDAL: a raster whose place is no number is refused, and one too far away") {
  CHECK(contains(refusal("<GeoTransform>nan, 10, 0, 50, 0, -5</GeoTransform>"), "not finite"));
  CHECK(contains(refusal("<GeoTransform>100, 10, 0, inf, 0, -5</GeoTransform>"), "not finite"));
  CHECK(contains(refusal("<GeoTransform>1e30, 10, 0, 50, 0, -5</GeoTransform>"), "subtract"));
}

TEST_CASE("GDAL: without a georeference the cell size is asked for") {
  const HeightGrid grid =
      read<float>("Float32", {1, 2, 3, 4, 5, 6}, "", "", {.cell = CellSize{30, 20}});
  CHECK(!grid.georeferenced);
  CHECK(grid.origin == Point{0, 20});
  CHECK(grid.cell_width == 30);
}

TEST_CASE("GDAL: degrees get cells in metres") {
  const HeightGrid grid =
      read<float>("Float32", {1, 2, 3, 4, 5, 6}, "",
                  "<SRS>EPSG:4326</SRS><GeoTransform>7, 1, 0, 46, 0, -1</GeoTransform>");
  CHECK(grid.degrees);
  CHECK(contains(grid.crs, "WGS 84"));
  CHECK(grid.cell_width == doctest::Approx(78846.8).epsilon(1e-5));
}

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
  CHECK(without(read<std::int16_t>("Int16", {1, -99, 3, 4, 5, -99}, nodata("-99"))) ==
        Places{1, 5});
  CHECK(without(read<float>("Float32", {1, NAN, 0.1F, 4, 5, 6}, nodata("0.1"))) == Places{1, 2});
  CHECK(without(read<float>("Float32", {1, 2, -3.4028235e38F, 4, 5, 6}, nodata("-3.402823e38"))) ==
        Places{2});
  CHECK(without(read<double>("Float64", {1, 2, -1e300, 4, NAN, 6}, nodata("-1e300"))) ==
        Places{2, 4});
  const HeightGridOptions asked{.nodata = 4};
  CHECK(without(read<float>("Float32", {1, 2, 3, 4, 5, 6}, nodata("5"), north_up, asked)) ==
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
    return read<std::int16_t>(
               "Int16", {1, 2, -9, 4, 5, 6},
               "<NoDataValue>-9</NoDataValue><Offset>100</Offset><Scale>" + scale + "</Scale>")
        .heights;
  };
  CHECK(scaled("0.5")[1] == 101);
  CHECK(std::isnan(scaled("0.5")[2]));
  CHECK(scaled("0.5").are_floats());
  CHECK(scaled("0.1")[5] == 6 * 0.1 + 100);
  CHECK(read<float>("Float32", {1, 2, 3, 4, 5, 0.1F}, "<Scale>0.1</Scale>").heights[5] ==
        0.1F * 0.1);
}

TEST_CASE("GDAL: of a scaled band, no data is a value of the file, and a warning says so") {
  const std::string scaled = "<Offset>100</Offset><Scale>0.1</Scale>";
  const auto grid = [&](double nodata, const std::string& band) {
    return read<std::int16_t>("Int16", {1, 2, -9999, 4, 5, 6}, band, north_up, {.nodata = nodata});
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
    const HeightGrid grid = read<T>(type, values, band);
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
    read<std::int64_t>("Int64", {1, 2, 3, 4, (1LL << 53) + 1, 6}, "");
  });
  CHECK(contains(message, "column 1, row 1"));
  CHECK(contains(message, "more than 53 bits"));
  CHECK(std::isnan(read<std::int64_t>("Int64", {1, INT64_MAX, 3, 4, 5, 6},
                                      "<NoDataValue>9223372036854775807</NoDataValue>")
                       .heights[1]));
}

TEST_CASE("GDAL: an infinite height is refused, with its place") {
  const auto message = [](double height) {
    return error_of<InputError>([&] { read<double>("Float64", {1, 2, 3, 4, height, 6}, ""); });
  };
  CHECK(contains(message(INFINITY), "column 1, row 1"));
  CHECK(contains(message(1e61), "column 1, row 1"));
}

TEST_CASE("GDAL: a header and a window, without the rest") {
  const ScratchFolder folder;
  folder.put("data.bin", bytes_of_values<float>({1, 2, 3, 4, 5, 6}));
  const auto path = folder.put("a.vrt", vrt("Float32", 4, north_up, ""));
  const HeightGrid header = read_height_grid_header(path);
  CHECK(header.columns == 3);
  CHECK(header.heights.empty());
  const HeightGrid part = read_height_window(path, {1, 0, 2, 2});
  CHECK(values_of(part) == std::vector<double>{2, 3, 5, 6});
  CHECK(part.origin == Point{115, 47.5});
  CHECK(contains(error_of<InputError>([&] { read_height_window(path, {2, 0, 2, 2}); }), "window"));
}

TEST_CASE("GDAL: what is no raster, what is cut short and what claims too much is refused") {
  const ScratchFolder folder;
  const auto text = folder.put("a.tif", "no raster");
  CHECK(contains(error_of<InputError>([&] { read_height_grid(text); }), "is no raster"));
  if (const auto real = test::real_input("dem/lux_elev.tif")) {
    std::ifstream file(*real, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const auto cut = folder.put("b.tif", bytes.substr(0, bytes.size() / 2));
    CHECK(contains(error_of<InputError>([&] { read_height_grid(cut); }), "b.tif"));
  }
  const auto huge = folder.put("c.vrt",
                               "<VRTDataset rasterXSize=\"200000000\" rasterYSize=\"200000000\">"
                               "<VRTRasterBand dataType=\"Byte\" band=\"1\"/></VRTDataset>");
  CHECK(
      contains(error_of<RefusedError>([&] { read_height_grid(huge); }), "more than this machine"));
}

TEST_CASE("GDAL: memory that the helper may not have is said, and what to do") {
  const ScratchFolder folder;
  const auto path = folder.put(
      "a.vrt",
      "<VRTDataset rasterXSize=\"32768\" rasterYSize=\"32768\"><VRTRasterBand dataType=\"Int64\" "
      "band=\"1\" blockYSize=\"2048\"/></VRTDataset>");
  HeightGridOptions options;
  options.gdal.memory_bytes = std::size_t{512} << 20;
  const std::string message = error_of<RefusedError>([&] {
    read_height_window(path, {0, 0, 32768, 2048}, options);
  });
  CHECK(contains(message, "takes more than 512 MiB of memory"));
  CHECK(contains(message, "--tiles"));
}

TEST_CASE("GDAL: reading ends when time is up, and when the user has had enough") {
  const ScratchFolder folder;
  folder.put("data.bin", bytes_of_values<float>({1, 2, 3, 4, 5, 6}));
  const auto path = folder.put("a.vrt", vrt("Float32", 4, north_up, ""));
  HeightGridOptions hurried;
  hurried.gdal.seconds = 0.01;  // GDAL's libraries alone take longer to load
  CHECK(contains(error_of<RefusedError>([&] { read_height_grid(path, hurried); }),
                 "did not finish reading it in 0.01 seconds"));
  HeightGridOptions cancelled;
  cancelled.gdal.keep_going = [] { return false; };
  CHECK(contains(error_of<RefusedError>([&] { read_height_grid(path, cancelled); }),
                 "was cancelled while GDAL read it"));
}

TEST_CASE("GDAL: a missing helper is said, with the package that brings it") {
  const ScratchFolder folder;
  const auto file = folder.put("a.tif", "II*");
  HeightGridOptions options;
  options.gdal.helper = folder / "nothing";
  const std::string message = error_of<InputError>([&] { read_height_grid(file, options); });
  CHECK(contains(message, "lepp-gdal"));
  CHECK(contains(message, "libgdal-dev"));
}

TEST_CASE("GDAL: real rasters have the size, range and cells that their list gives") {
  struct Known {
    const char* name;
    std::uint32_t columns, rows;
    double width, height, low, high;
    std::size_t without;
  };
  for (const Known& known :
       {Known{"riorgbify_elev_nonsquare.tif", 512, 512, 6.7218, 6.0590, 0.436, 114.92, 0},
        Known{"pysheds_dem.tif", 367, 359, 78.16, 92.42, 147, 298, 0},
        Known{"lux_elev.tif", 95, 90, 599.7, 926.9, 141, 547, 3942},
        Known{"pyterra_dgm5_southup.tif", 201, 401, 5, 5, 513.42, 562.54, 0}}) {
    CAPTURE(known.name);
    const auto path = test::real_input(std::string("dem/") + known.name);
    if (!path) continue;
    const HeightGrid grid = read_height_grid(*path);
    CHECK(grid.columns == known.columns);
    CHECK(grid.rows == known.rows);
    CHECK(grid.cell_width == doctest::Approx(known.width).epsilon(1e-3));
    CHECK(grid.cell_height == doctest::Approx(known.height).epsilon(1e-3));
    double low = INFINITY, high = -INFINITY;
    std::size_t without = 0;
    for (const double h : values_of(grid)) {
      without += std::isnan(h);
      low = std::fmin(low, h);
      high = std::fmax(high, h);
    }
    CHECK(low == doctest::Approx(known.low).epsilon(1e-3));
    CHECK(high == doctest::Approx(known.high).epsilon(1e-3));
    CHECK(without == known.without);
  }
}
