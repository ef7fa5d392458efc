#include "lepp/io/gdal_process.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "io/gdal_rasters.hpp"
#include "lepp/geometry/error.hpp"
#include "support/real_inputs.hpp"

// Only built where GDAL is.

using namespace lepp;
using namespace lepp::test;
namespace fs = std::filesystem;

namespace {

std::string refusal(const std::string& georeference) {
  return error_of<InputError>([&] {
    read_values<float>("Float32", {1, 2, 3, 4, 5, 6}, "", georeference);
  });
}

}  // namespace

TEST_CASE("GDAL: a north-up raster, its samples in the middle of pixels") {
  const HeightGrid grid = read_values<float>("Float32", {1, 2, 3, 4, 5, 6}, "");
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
  const HeightGrid grid = read_values<float>("Float32", {1, 2, 3, 4, 5, 6}, "",
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
      read_values<float>("Float32", {1, 2, 3, 4, 5, 6}, "", "", {.cell = CellSize{30, 20}});
  CHECK(!grid.georeferenced);
  CHECK(grid.origin == Point{0, 20});
  CHECK(grid.cell_width == 30);
}

TEST_CASE("GDAL: degrees get cells in metres") {
  const HeightGrid grid =
      read_values<float>("Float32", {1, 2, 3, 4, 5, 6}, "",
                         "<SRS>EPSG:4326</SRS><GeoTransform>7, 1, 0, 46, 0, -1</GeoTransform>");
  CHECK(grid.degrees);
  CHECK(contains(grid.crs, "WGS 84"));
  CHECK(grid.cell_width == doctest::Approx(78846.8).epsilon(1e-5));
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

TEST_CASE("GDAL: a mosaic may name its parts from the folder that the user is in") {
  const ScratchFolder folder;
  const auto part = folder.put("part.asc",
                               "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\n"
                               "cellsize 1\n1 2\n3 4\n");
  const auto path = folder.put(
      "a.vrt",
      "<VRTDataset rasterXSize=\"2\" rasterYSize=\"2\">"
      "<GeoTransform>0, 1, 0, 2, 0, -1</GeoTransform><VRTRasterBand dataType=\"Float32\" "
      "band=\"1\"><SimpleSource><SourceFilename relativeToVRT=\"0\">" +
          fs::relative(part).string() +
          "</SourceFilename><SourceBand>1</SourceBand></SimpleSource></VRTRasterBand>"
          "</VRTDataset>");
  const HeightGrid grid = read_height_grid(path);
  CHECK(values_of(grid) == std::vector<double>{1, 2, 3, 4});
  REQUIRE(grid.files.size() == 2);
  CHECK(fs::equivalent(grid.files[1], part));
  fs::remove(part);
  const std::string message = error_of<InputError>([&] { read_height_grid(path); });
  CHECK(contains(message, "part.asc"));
  CHECK(contains(message, "put the file that it names there"));
  CHECK_FALSE(contains(message, "damaged"));
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
