#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "lepp/io/gdal_options.hpp"
#include "lepp/io/gdal_record.hpp"
#include "lepp/io/raster_layout.hpp"

namespace lepp {

/// Size and georeference of band 1 of a raster, without heights. A value of no data that is given
/// may be worth a warning.
/// \throw InputError    no such program; not a raster, rotated, mirrored
/// \throw RefusedError  time or memory limit
HeightGrid read_gdal_header(const std::filesystem::path& path, std::optional<double> nodata,
                            const GdalOptions& options);

/// The same, and the heights of a window of it, which come over a pipe. `prepare` sees the header
/// of the whole before the window is cut out.
/// \param window  nothing: all of it
/// \param nodata  in place of what the file declares
/// \throw InputError    a height is infinite or too large, the file is damaged
/// \throw RefusedError  more than the memory of this machine
HeightGrid read_gdal_heights(const std::filesystem::path& path,
                             const std::optional<GridWindow>& window, std::optional<double> nodata,
                             const std::function<void(HeightGrid&)>& prepare,
                             const GdalOptions& options);

/// Lines and polygons of a vector file, in the coordinate system of the grid.
/// \throw as above; InputError  a system of the grid that GDAL cannot read, where the file has one;
///        OutputError  no room for a temporary file
GdalLines read_gdal_lines(const std::filesystem::path& path, const std::string& grid_crs,
                          const GdalOptions& options);

}  // namespace lepp
