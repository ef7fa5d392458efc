#include "lepp/io/geojson.hpp"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "lepp/geometry/error.hpp"
#include "lepp/io/text_file.hpp"

namespace lepp {

namespace {

using Json = nlohmann::json;

class GeoJsonReader {
 public:
  explicit GeoJsonReader(const std::string& name) : name_(name), where_(name) {}

  GeoJson read(const Json& root) {
    const std::string type = type_of(root);
    if (type == "FeatureCollection") {
      for (const Json& feature : list(root, "features")) add_feature(feature);
    } else {
      add_feature(root);
    }
    result_.epsg = epsg_of(root);
    return std::move(result_);
  }

 private:
  void add_feature(const Json& feature) {
    GdalFeature& added = result_.features.emplace_back();
    added.name = "feature " + std::to_string(result_.features.size());
    where_ = name_ + ", " + added.name;
    if (type_of(feature) != "Feature") return add_parts(feature, added.parts);
    const Json& geometry = member(feature, "geometry");
    if (!geometry.is_null()) add_parts(geometry, added.parts);
  }

  // Geometries in collections one after the other; collections may hold collections.
  void add_parts(const Json& whole, std::vector<GdalPart>& parts) const {
    std::vector<const Json*> waiting = {&whole};
    while (!waiting.empty()) {
      const Json& geometry = *waiting.back();
      waiting.pop_back();
      const std::string type = type_of(geometry);
      if (type != "GeometryCollection") {
        add_geometry(type, geometry, parts);
        continue;
      }
      const Json& all = list(geometry, "geometries");
      for (auto g = all.rbegin(); g != all.rend(); ++g) waiting.push_back(&*g);
    }
  }

  void add_geometry(const std::string& type, const Json& geometry,
                    std::vector<GdalPart>& parts) const {
    const bool many = type.starts_with("Multi");
    const std::string kind = many ? type.substr(5) : type;
    if (kind != "LineString" && kind != "Polygon") {
      if (kind != "Point") fail("\"" + type.substr(0, 40) + "\" is no type of GeoJSON geometry");
      parts.push_back({type, {}, {}});
      return;
    }
    const Json& coordinates = list(geometry, "coordinates");
    if (!many) return add_part(kind, coordinates, parts);
    for (const Json& part : coordinates) add_part(kind, part, parts);
  }

  void add_part(const std::string& kind, const Json& coordinates,
                std::vector<GdalPart>& parts) const {
    GdalPart& part = parts.emplace_back();
    part.kind = kind;
    if (kind == "LineString") return add_positions(coordinates, part);
    if (!coordinates.is_array()) fail("the rings of a polygon are no list");
    for (const Json& ring : coordinates) add_positions(ring, part);
  }

  void add_positions(const Json& positions, GdalPart& part) const {
    if (!positions.is_array()) fail("the positions of a line or ring are no list");
    auto& points = part.rings.emplace_back();
    std::vector<double> heights;
    for (const Json& position : positions) {
      bool numbers = position.is_array() && position.size() >= 2;
      for (std::size_t i = 0; numbers && i < std::min<std::size_t>(position.size(), 3); ++i)
        numbers = position[i].is_number();
      if (!numbers) fail("a position is not a list of two or three numbers");
      points.push_back({position[0].get<double>(), position[1].get<double>()});
      if (position.size() >= 3) heights.push_back(position[2].get<double>());
    }
    if (heights.empty()) return;
    if (heights.size() != points.size())
      fail("some positions of a line have heights, others have none");
    part.heights.push_back(std::move(heights));
  }

  const Json& member(const Json& object, const char* key) const {
    const auto found = object.is_object() ? object.find(key) : object.end();
    if (found == object.end()) fail("\"" + std::string(key) + "\" is missing");
    return *found;
  }

  std::string type_of(const Json& object) const {
    const Json& type = member(object, "type");
    if (!type.is_string()) fail("\"type\" is no text");
    return type.get<std::string>();
  }

  const Json& list(const Json& object, const char* key) const {
    const Json& found = member(object, key);
    if (!found.is_array()) fail("\"" + std::string(key) + "\" is no list");
    return found;
  }

  // "urn:ogc:def:crs:EPSG::32608", "EPSG:32608"; OGC:1.3:CRS84 is 4326 with longitude first.
  static std::optional<int> epsg_of(const Json& root) {
    const Json name = root.value(Json::json_pointer("/crs/properties/name"), Json());
    if (!name.is_string()) return std::nullopt;
    const auto text = name.get<std::string>();
    if (text.ends_with("CRS84")) return 4326;
    const std::size_t digits = text.rfind(':') + 1;
    int code = 0;
    const auto [end, error] =
        std::from_chars(text.data() + digits, text.data() + text.size(), code);
    const bool known =
        text.find("EPSG") != text.npos && error == std::errc() && end == text.data() + text.size();
    return known ? std::optional(code) : std::nullopt;
  }

  [[noreturn]] void fail(std::string problem) const {
    throw InputError(where_, std::move(problem), "write GeoJSON as RFC 7946 says");
  }

  const std::string& name_;
  std::string where_;
  GeoJson result_;
};

}  // namespace

GeoJson read_geojson(const std::filesystem::path& path) {
  const TextFile file = read_text_file(path);
  try {
    return GeoJsonReader(file.name).read(Json::parse(file.text));
  } catch (const Json::parse_error& error) {
    throw InputError(file.name + ", byte " + std::to_string(error.byte), "is no JSON",
                     "write GeoJSON as RFC 7946 says");
  } catch (const Json::out_of_range&) {
    throw InputError(file.name, "holds a number that no double holds", "correct it");
  }
}

}  // namespace lepp
