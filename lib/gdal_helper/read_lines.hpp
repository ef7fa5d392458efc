#pragma once

#include <string>

#include "lepp/io/gdal_record.hpp"

namespace lepp::gdal_helper {

/// All layers of a vector file, and whether they are in another coordinate system than the grid.
/// \param grid_wkt  empty if not known
GdalLines read_lines(const std::string& file, const std::string& grid_wkt);

}  // namespace lepp::gdal_helper
