#include "lepp/io/terrain_lines.hpp"

#include <doctest/doctest.h>

#include "io/scratch_folder.hpp"
#include "lepp/geometry/error.hpp"

using namespace lepp;
using test::contains;
using test::error_of;
using test::ScratchFolder;

namespace {

const std::string line = R"({"type":"LineString","coordinates":[[0,1,7],[2,3,8]]})";
const std::string polygon =
    R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[0,4],[0,0]],[[1,1],[2,1],[1,2],[1,1]]]})";
const std::string point = R"({"type":"Point","coordinates":[0,1]})";

std::string with_crs(const std::string& geometry, const std::string& epsg) {
  return R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:)" + epsg +
         R"("}},"features":[{"type":"Feature","geometry":)" + geometry + "}]}";
}

}  // namespace

TEST_CASE("breaklines: lines with heights are hard, rings of polygons are closed lines") {
  const ScratchFolder folder;
  const auto path = folder.put("a.json", line);
  const auto lines = read_breaklines(path);
  REQUIRE(lines.size() == 1);
  CHECK(lines[0].heights == std::vector<double>{7, 8});
  CHECK(contains(lines[0].name, "a.json, feature 1"));
  CHECK(read_breaklines(path, {.ignore_heights = true})[0].heights.empty());
  const auto rings = read_breaklines(folder.put("b.json", polygon));
  REQUIRE(rings.size() == 2);
  CHECK(rings[0].points.front() == rings[0].points.back());
  CHECK(rings[1].points.size() == 4);
}

TEST_CASE("clip polygons keep their rings together") {
  const ScratchFolder folder;
  const auto polygons = read_clip_polygons(folder.put("b.geojson", polygon));
  REQUIRE(polygons.size() == 1);
  CHECK(polygons[0].rings.size() == 2);
}

TEST_CASE("features that are no lines, or no polygons, are named") {
  const ScratchFolder folder;
  const auto path = folder.put("a.json", point), lines = folder.put("b.json", line);
  CHECK(contains(error_of<InputError>([&] { read_breaklines(path); }),
                 "feature 1: is a Point where lines belong"));
  CHECK(contains(error_of<InputError>([&] { read_clip_polygons(lines); }),
                 "feature 1: is a LineString where polygons belong"));
  const auto empty = folder.put("c.json", R"({"type":"FeatureCollection","features":[]})");
  CHECK(contains(error_of<InputError>([&] { read_breaklines(empty); }), "holds no geometry"));
}

TEST_CASE("lines in another coordinate system than the grid need lepp-gdal, others do not") {
  const ScratchFolder folder;
  const auto path = folder.put("a.json", with_crs(line, "32608")),
             bare = folder.put("b.json", line);
  const auto fate = [&](const std::filesystem::path& file, const std::string& wkt) {
    TerrainLineOptions options;
    options.grid_crs = wkt;
    options.gdal.helper = folder / "nothing";
    return error_of<InputError>([&] { read_breaklines(file, options); });
  };
  CHECK(contains(fate(path, R"(PROJCS["x",AUTHORITY["EPSG","32611"]])"), "lepp-gdal"));
  CHECK(contains(fate(path, R"(PROJCRS["x",ID["EPSG",32611]])"), "lepp-gdal"));
  const std::string inner = R"(GEOGCS["y",AUTHORITY["EPSG","4326"]])";
  CHECK(fate(path, R"(PROJCS["x",)" + inner + R"(,AUTHORITY["EPSG","32608"]])") == "");
  CHECK(contains(fate(path, R"(PROJCS["x",)" + inner + R"(,UNIT["metre",1]])"), "lepp-gdal"));
  CHECK(fate(path, "") == "");
  CHECK(contains(fate(bare, R"(PROJCS["x"])"), "lepp-gdal"));  // could be degrees
  CHECK(fate(bare, R"(GEOGCS["x"])") == "");
  const auto metres =
      folder.put("c.json", R"({"type":"LineString","coordinates":[[0,1],[2,300]]})");
  CHECK(fate(metres, R"(PROJCS["x"])") == "");
}
