#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "lepp/io/gdal_record.hpp"

namespace lepp {

/// What a GeoJSON file holds, in the terms of gdal_record.hpp.
struct GeoJson {
  std::vector<GdalFeature> features;
  std::optional<int> epsg;  ///< of the member "crs", which older files have
};

/// Reads a GeoJSON text: a geometry, a Feature or a FeatureCollection. Collections are taken apart;
/// features are numbered from 1.
/// \throw InputError  no JSON, with the byte; else naming the feature: a member missing or of
///                    another type, a position of less than two numbers, heights at some positions
///                    of a line only
/// Source RFC 7946
GeoJson read_geojson(const std::filesystem::path& path);

}  // namespace lepp
