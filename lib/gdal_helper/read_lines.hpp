#pragma once

#include <string>

#include "lepp/io/gdal_record.hpp"

namespace lepp::gdal_helper {

/// All layers of a vector file, converted to the coordinate system of the grid where both are known
/// and differ. Heights are not converted.
/// \param grid_wkt  empty if not known
GdalLines read_lines(const std::string& file, const std::string& grid_wkt);

}  // namespace lepp::gdal_helper
