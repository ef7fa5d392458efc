#include "lepp/io/geojson.hpp"

#include <doctest/doctest.h>

#include "io/scratch_folder.hpp"
#include "lepp/geometry/error.hpp"

using namespace lepp;
using test::contains;
using test::error_of;
using test::ScratchFolder;

namespace {

GeoJson read(const std::string& text) {
  const ScratchFolder folder;
  return read_geojson(folder.put("a.geojson", text));
}

std::string refusal(const std::string& text) {
  return error_of<InputError>([&] { read(text); });
}

std::string feature(const std::string& geometry) {
  return R"({"type":"Feature","properties":null,"geometry":)" + geometry + "}";
}

std::string collection(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

const std::string line = R"({"type":"LineString","coordinates":[[0,1],[2.5,-3e2]]})";

}  // namespace

TEST_CASE("GeoJSON: a geometry, a feature and a collection of features are the same") {
  for (const std::string& text : {line, feature(line), collection(feature(line))}) {
    CAPTURE(text);
    const GeoJson json = read(text);
    REQUIRE(json.features.size() == 1);
    CHECK(json.features[0].name == "feature 1");
    REQUIRE(json.features[0].parts.size() == 1);
    CHECK(json.features[0].parts[0].kind == "LineString");
    CHECK(json.features[0].parts[0].rings[0] == std::vector<Point>{{0, 1}, {2.5, -300}});
    CHECK(json.features[0].parts[0].heights.empty());
  }
}

TEST_CASE("GeoJSON: all kinds of lines and polygons, in collections of collections") {
  const GeoJson json = read(
      R"({"type":"GeometryCollection","geometries":[)"
      R"({"type":"MultiLineString","coordinates":[[[0,0,5],[1,0,6]],[[2,2],[3,3]]]},)"
      R"({"type":"GeometryCollection","geometries":[)"
      R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[0,4],[0,0]],[[1,1],[2,1],[1,2],[1,1]]]}]},)"
      R"({"type":"MultiPolygon","coordinates":[[[[0,0],[1,0],[0,1],[0,0]]]]},)"
      R"({"type":"MultiPoint","coordinates":[[0,0]]}]})");
  REQUIRE(json.features.size() == 1);
  const auto& parts = json.features[0].parts;
  REQUIRE(parts.size() == 5);
  CHECK(parts[0].heights[0] == std::vector<double>{5, 6});
  CHECK(parts[1].heights.empty());
  CHECK(parts[2].kind == "Polygon");
  CHECK(parts[2].rings.size() == 2);
  CHECK(parts[3].rings[0].size() == 4);
  CHECK(parts[4].kind == "MultiPoint");
}

TEST_CASE("GeoJSON: features without geometry keep their numbers") {
  const GeoJson json = read(collection(feature("null") + "," + feature(line)));
  REQUIRE(json.features.size() == 2);
  CHECK(json.features[0].parts.empty());
  CHECK(json.features[1].name == "feature 2");
}

TEST_CASE("GeoJSON: the coordinate system of older files") {
  const auto epsg = [](const std::string& name) {
    return read(R"({"type":"FeatureCollection","features":[],"crs":{"type":"name","properties":)"
                R"({"name":")" +
                name + R"("}}})")
        .epsg;
  };
  CHECK(epsg("urn:ogc:def:crs:EPSG::32608") == 32608);
  CHECK(epsg("EPSG:4326") == 4326);
  CHECK(epsg("urn:ogc:def:crs:OGC:1.3:CRS84") == 4326);
  CHECK(!epsg("my own"));
  CHECK(!read(line).epsg);
  CHECK(!read(R"({"type":"FeatureCollection","features":[],"crs":null})").epsg);
}

TEST_CASE("GeoJSON: what is wrong is named, with its feature") {
  const std::string second = feature(line) + ",";
  CHECK(contains(refusal("{"), "a.geojson, byte "));
  CHECK(contains(refusal("[1,2]"), "\"type\" is missing"));
  CHECK(contains(refusal(R"({"type":7})"), "\"type\" is no text"));
  CHECK(contains(refusal(R"({"type":"FeatureCollection"})"), "\"features\" is missing"));
  CHECK(contains(refusal(collection(second + R"({"type":"Feature"})")),
                 "a.geojson, feature 2: \"geometry\" is missing"));
  CHECK(contains(refusal(collection(second + feature(R"({"type":"Circle"})"))),
                 "feature 2: \"Circle\""));
  const auto coordinates = [](const std::string& list) {
    return refusal(R"({"type":"LineString","coordinates":)" + list + "}");
  };
  CHECK(contains(coordinates("7"), "\"coordinates\" is no list"));
  CHECK(contains(coordinates("[[0,0],[1]]"), "two or three numbers"));
  CHECK(contains(coordinates(R"([[0,0],["1",2]])"), "two or three numbers"));
  CHECK(contains(coordinates("[[0,0,1],[1,1]]"), "some positions"));
  CHECK(contains(coordinates("[[0,0],[1e999,1]]"), "a.geojson"));
}
