#include "lepp/io/terrain_lines.hpp"

#include <cmath>
#include <utility>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/io/crs_wkt.hpp"
#include "lepp/io/file_kind.hpp"
#include "lepp/io/gdal_process.hpp"
#include "lepp/io/geojson.hpp"

namespace lepp {

namespace {

namespace fs = std::filesystem;

bool is_geojson(const fs::path& path) {
  const std::string kind = file_kind(path);
  return kind == ".geojson" || kind == ".json";
}

bool could_be_degrees(const std::vector<GdalFeature>& features) {
  for (const GdalFeature& feature : features) {
    for (const GdalPart& part : feature.parts) {
      for (const auto& ring : part.rings) {
        for (const Point p : ring) {
          if (std::abs(p.x) > 180 || std::abs(p.y) > 90) return false;
        }
      }
    }
  }
  return true;
}

// True if its coordinates are those of the grid for all that is known. Where the grid's system has
// no code, as in .prj files of ESRI, GDAL has to compare the two.
bool is_as_grid(const GeoJson& json, const std::string& grid_crs) {
  if (grid_crs.empty()) return true;
  const CrsWkt grid = parse_crs_wkt(grid_crs);
  if (json.epsg) return json.epsg == grid.epsg;
  return grid.is_geographic || !could_be_degrees(json.features);
}

std::vector<GdalFeature> read_by_gdal(const fs::path& path, const TerrainLineOptions& options) {
  GdalLines lines = read_gdal_lines(path, options.grid_crs, options.gdal);
  for (const std::string& from : lines.converted_from) {
    if (options.warnings == nullptr) continue;
    options.warnings->push_back(path.string() + ": converted from " + from + " to " +
                                lines.converted_to + ", that of the grid");
  }
  return std::move(lines.features);
}

std::vector<GdalFeature> read_features(const fs::path& path, const TerrainLineOptions& options) {
  std::vector<GdalFeature> features;
  if (is_geojson(path)) {
    GeoJson json = read_geojson(path);
    features =
        is_as_grid(json, options.grid_crs) ? std::move(json.features) : read_by_gdal(path, options);
  } else {
    features = read_by_gdal(path, options);
  }
  for (const GdalFeature& feature : features) {
    if (!feature.parts.empty()) return features;
  }
  throw InputError(path.string(), "holds no geometry", "give lines or polygons");
}

[[noreturn]] void refuse_kind(const fs::path& path, const GdalFeature& feature,
                              const GdalPart& part, const char* wanted) {
  throw InputError(path.string() + ", " + feature.name,
                   "is a " + part.kind + " where " + wanted + " belong", "remove it");
}

Breakline line_of(const GdalPart& part, std::size_t ring, const std::string& name,
                  const TerrainLineOptions& options) {
  Breakline line{part.rings[ring], {}, name};
  if (!options.ignore_heights && ring < part.heights.size()) line.heights = part.heights[ring];
  const bool closed = line.points.empty() || line.points.front() == line.points.back();
  if (part.kind == "Polygon" && !closed) {
    line.points.push_back(line.points.front());
    if (!line.heights.empty()) line.heights.push_back(line.heights.front());
  }
  return line;
}

}  // namespace

std::vector<Breakline> read_breaklines(const fs::path& path, const TerrainLineOptions& options) {
  std::vector<Breakline> lines;
  for (const GdalFeature& feature : read_features(path, options)) {
    for (const GdalPart& part : feature.parts) {
      if (part.kind != "LineString" && part.kind != "Polygon")
        refuse_kind(path, feature, part, "lines");
      for (std::size_t r = 0; r < part.rings.size(); ++r)
        lines.push_back(line_of(part, r, path.string() + ", " + feature.name, options));
    }
  }
  return lines;
}

std::vector<ClipPolygon> read_clip_polygons(const fs::path& path,
                                            const TerrainLineOptions& options) {
  std::vector<ClipPolygon> polygons;
  for (GdalFeature& feature : read_features(path, options)) {
    for (GdalPart& part : feature.parts) {
      if (part.kind != "Polygon") refuse_kind(path, feature, part, "polygons");
      polygons.push_back({std::move(part.rings), path.string() + ", " + feature.name});
    }
  }
  return polygons;
}

}  // namespace lepp
