#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lepp/io/gdal_record.hpp"
#include "lepp/terrain/height_grid.hpp"

namespace lepp::gdal_helper {

struct RasterTask {
  std::string file;
  bool header_only = false;
  std::optional<GridWindow> window;  ///< nothing: all of it
  std::optional<double> nodata;      ///< in place of what the file declares
  std::uint64_t memory_bytes = 0;    ///< the limit, for messages
};

/// Sends what gdal_record.hpp says about band 1 of a raster, or why it cannot.
void send_raster(const RasterTask& task);

}  // namespace lepp::gdal_helper
