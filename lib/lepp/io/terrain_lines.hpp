#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lepp/io/gdal_options.hpp"
#include "lepp/terrain/terrain_domain.hpp"

namespace lepp {

struct TerrainLineOptions {
  /// HeightGrid::crs. Lines in another coordinate system, where both are known, are converted by
  /// lepp-gdal; their heights are not.
  std::string grid_crs = {};
  /// Lines are soft even if the file has heights for them, as some programs write 0 for all.
  bool ignore_heights = false;
  GdalOptions gdal = {};
  std::vector<std::string>* warnings = nullptr;  ///< gets a sentence about each conversion
};

/// Reads lines, and rings of polygons as closed lines. A line is hard if the file has heights for
/// it. GeoJSON (.geojson, .json) is read here, everything else by lepp-gdal: shapefiles,
/// GeoPackage, ...
///
/// GeoJSON without a coordinate system has longitudes and latitudes, says RFC 7946; many files do
/// not. They are taken as such if the grid's system is known and has no degrees, and all numbers
/// could be degrees; else as coordinates of the grid.
/// \throw InputError  naming the feature: points, or what else is no line; nothing in the file; a
///                    conversion that is needed and fails, or lepp-gdal for it is not there
std::vector<Breakline> read_breaklines(const std::filesystem::path& path,
                                       const TerrainLineOptions& options = {});

/// Reads polygons; heights are not looked at. \throw InputError  likewise, about what is no polygon
std::vector<ClipPolygon> read_clip_polygons(const std::filesystem::path& path,
                                            const TerrainLineOptions& options = {});

}  // namespace lepp
