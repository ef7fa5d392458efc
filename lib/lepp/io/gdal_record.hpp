#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/point.hpp"
#include "lepp/io/record_archive.hpp"

namespace lepp {

/// What the helper lepp-gdal sends back. Nothing here depends on GDAL.
///
/// Of a raster: a GdalRaster; if heights were asked for, then blocks of rows, each its number of
/// rows (32 bits, not 0) and its heights, floats or doubles, NaN where there is no data; a 0; and a
/// GdalRasterEnd.
/// Of a vector file: one GdalLines.

/// Why there is nothing else.
struct GdalFailure {
  ErrorKind kind = ErrorKind::input;
  std::string where;  ///< appended to the file's name; may be empty
  std::string problem, remedy;
};

/// Size and georeference of a raster, as HeightGrid has them.
struct GdalRaster {
  std::optional<GdalFailure> failure;
  std::uint32_t columns = 0, rows = 0;
  bool georeferenced = false, degrees = false;
  Point origin;  ///< center of the first pixel
  double step_x = 1, step_y = -1;
  std::string crs;       ///< WKT
  bool doubles = false;  ///< heights come as such, else as floats
  std::vector<std::string> warnings;
  std::vector<std::string> files;  ///< all that GDAL reads for it, such as the parts of a mosaic
};

/// What is known only after all heights.
struct GdalRasterEnd {
  std::optional<GdalFailure> failure;
};

/// A part of a feature's geometry.
struct GdalPart {
  std::string kind;                          ///< "LineString", "Polygon", or what it is instead
  std::vector<std::vector<Point>> rings;     ///< of a line one
  std::vector<std::vector<double>> heights;  ///< likewise, if the part has heights
};

struct GdalFeature {
  std::string name;  ///< "feature 3", "layer streams, feature 3"
  std::vector<GdalPart> parts;
};

struct GdalLines {
  std::optional<GdalFailure> failure;
  /// Names of coordinate systems, one per layer that was converted to that of the grid.
  std::vector<std::string> converted_from;
  std::string converted_to;
  std::vector<GdalFeature> features;
};

inline constexpr RecordKind gdal_raster_kind = {{'g', 'd', 'a', 'l', 'r', 'a', 's', 't'}, 3};
inline constexpr RecordKind gdal_end_kind = {{'g', 'd', 'a', 'l', 'r', 'e', 'n', 'd'}, 2};
inline constexpr RecordKind gdal_lines_kind = {{'g', 'd', 'a', 'l', 'l', 'i', 'n', 'e'}, 1};

std::vector<std::byte> encode(const GdalRaster& record);
std::vector<std::byte> encode(const GdalRasterEnd& record);
std::vector<std::byte> encode(const GdalLines& record);

/// \return  false if the bytes are not one complete, undamaged record
bool decode(std::span<const std::byte> bytes, GdalRaster& record);
bool decode(std::span<const std::byte> bytes, GdalRasterEnd& record);
bool decode(std::span<const std::byte> bytes, GdalLines& record);

}  // namespace lepp
