#include <doctest/doctest.h>

#include <algorithm>

#include "io/file_size_limit.hpp"
#include "io/scratch_folder.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/io/height_grid_read.hpp"
#include "lepp/io/terrain_lines.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/real_inputs.hpp"

// Only built where GDAL is. Vector files of our own are CSV with WKT, which GDAL reads.

using namespace lepp;
using test::contains;
using test::error_of;
using test::ScratchFolder;

namespace {

std::string csv(const std::vector<std::string>& geometries) {
  std::string text = "id,WKT\n";
  for (const std::string& geometry : geometries) text += "1,\"" + geometry + "\"\n";
  return text;
}

// Zone 32 of UTM as .prj files of ESRI have it, without a code.
const std::string esri_utm =
    R"(PROJCS["WGS_1984_UTM_Zone_32N",GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",)"
    R"(SPHEROID["WGS_1984",6378137.0,298.257223563]],PRIMEM["Greenwich",0.0],)"
    R"(UNIT["Degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],)"
    R"(PARAMETER["False_Easting",500000.0],PARAMETER["False_Northing",0.0],)"
    R"(PARAMETER["Central_Meridian",9.0],PARAMETER["Scale_Factor",0.9996],)"
    R"(PARAMETER["Latitude_Of_Origin",0.0],UNIT["Meter",1.0]])";

std::string geojson(const std::string& crs, const std::string& line) {
  return R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":")" + crs +
         R"("}},"features":[{"type":"Feature","properties":{},"geometry":{"type":"LineString",)" +
         R"("coordinates":)" + line + "}}]}";
}

}  // namespace

TEST_CASE("GDAL: lines and polygons, flat and with heights, of curves their chords") {
  const ScratchFolder folder;
  const auto path = folder.put(
      "a.csv",
      csv({"LINESTRING (0 0,1 2)", "MULTILINESTRING Z ((0 0 5,1 0 6),(2 2 7,3 3 8))",
           "POLYGON ((0 0,4 0,0 4,0 0),(1 1,2 1,1 2,1 1))", "CIRCULARSTRING (0 0,1 1,2 0)"}));
  const auto lines = read_breaklines(path);
  REQUIRE(lines.size() == 6);
  CHECK(lines[0].points == std::vector<Point>{{0, 0}, {1, 2}});
  CHECK(lines[0].heights.empty());
  CHECK(lines[1].heights == std::vector<double>{5, 6});
  CHECK(lines[2].heights == std::vector<double>{7, 8});
  CHECK(lines[4].points.size() == 4);
  CHECK(lines[5].points.size() > 10);
  CHECK(contains(lines[5].name, "feature 4"));
}

TEST_CASE("GDAL: a point among lines is named, and what is no vector file refused") {
  const ScratchFolder folder;
  const auto path = folder.put("a.csv", csv({"LINESTRING (0 0,1 2)", "POINT (1 1)"}));
  CHECK(contains(error_of<InputError>([&] { read_breaklines(path); }),
                 "feature 2: is a Point where lines belong"));
  const auto text = folder.put("a.shp", "no shapes");
  CHECK(contains(error_of<InputError>([&] { read_breaklines(text); }), "a.shp"));
}

TEST_CASE("the streams of a real site become edges of the domain of its grid") {
  const auto streams = test::real_input("dem/mesher_granger_stream.shp");
  const auto dem = test::real_input("dem/mesher_granger_dem.tif");
  if (!streams || !dem) return;
  const HeightGrid grid = read_height_grid(*dem);
  std::vector<std::string> warnings;
  const auto lines = read_breaklines(*streams, {.grid_crs = grid.crs, .warnings = &warnings});
  CHECK(lines.size() == 197);
  REQUIRE(warnings.size() == 1);  // two datums whose coordinates agree to a metre or two
  CHECK(contains(warnings[0], "from NAD83 / UTM zone 8N to WGS 84 / UTM zone 8N"));
  const TerrainDomain domain = terrain_domain(grid, {.breaklines = lines});
  CHECK(domain.warnings.size() == 2);
  const Mesh mesh = constrained_delaunay(domain.pslg).mesh;
  CHECK(std::ranges::count_if(domain.pslg.segments,
                              [](const Segment& s) { return s.curve != CurveId(0U); }) > 1000);
  CHECK(mesh.vertex_count() == domain.pslg.points.size());
}

TEST_CASE("GDAL: lines in another coordinate system are converted to that of the grid") {
  const ScratchFolder folder;
  const auto elsewhere = test::real_input("dem/topotoolbox_bigtujunga.tif");
  if (!elsewhere) return;
  // Zone 11 of UTM has its middle at 117 degrees west: there x is 500 km.
  const auto path =
      folder.put("b.geojson", R"({"type":"LineString","coordinates":[[-117,0],[-117,34.4]]})");
  const std::string crs = read_height_grid_header(*elsewhere).crs;
  const auto lines = read_breaklines(path, {.grid_crs = crs});
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].points[0].x == doctest::Approx(500000).epsilon(1e-9));
  CHECK(lines[0].points[1].y == doctest::Approx(3806500).epsilon(1e-3));
}

TEST_CASE("GDAL: GeoJSON that says what it is in is converted to a system without a code") {
  const ScratchFolder folder;
  std::vector<std::string> warnings;
  const TerrainLineOptions options{.grid_crs = esri_utm, .warnings = &warnings};
  for (const char* crs : {"urn:ogc:def:crs:OGC:1.3:CRS84", "EPSG:4326"}) {
    CAPTURE(crs);
    const auto path = folder.put("a.geojson", geojson(crs, "[[9,0],[9,42]]"));
    const auto lines = read_breaklines(path, options);
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].points[0].x == doctest::Approx(500000).epsilon(1e-9));
    CHECK(lines[0].points[1].y == doctest::Approx(4649776).epsilon(1e-6));
  }
  CHECK(warnings.size() == 2);
  const auto same = folder.put("b.geojson", geojson("EPSG:32632", "[[500000,1],[500001,2]]"));
  CHECK(read_breaklines(same, options)[0].points == std::vector<Point>{{500000, 1}, {500001, 2}});
  CHECK(warnings.size() == 2);
}

TEST_CASE("GDAL: lines are never taken as they are because the grid's system got lost") {
  const ScratchFolder folder;
  const auto path = folder.put("a.geojson", geojson("EPSG:4326", "[[9,0],[9,42]]"));
  CHECK(contains(
      error_of<InputError>([&] { read_breaklines(path, {.grid_crs = R"(PROJCS["no system"])"}); }),
      "coordinate system of the grid"));
  const std::string full = error_of<OutputError>([&] {
    const test::FileSizeLimit no_space(0);
    read_breaklines(path, {.grid_crs = esri_utm});
  });
  CHECK(contains(full, "grid.wkt"));
}
