#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/scratch_folder.hpp"
#include "lepp/io/height_grid_read.hpp"

// Rasters of our own for GDAL: VRT files, a header over bytes.

namespace lepp::test {

/// A raster of 3 x 2 over the bytes in "data.bin".
inline std::string vrt(const std::string& type, int bytes, const std::string& georeference,
                       const std::string& band) {
  const std::string pixel = std::to_string(bytes), line = std::to_string(3 * bytes);
  return "<VRTDataset rasterXSize=\"3\" rasterYSize=\"2\">" + georeference +
         "<VRTRasterBand dataType=\"" + type + "\" band=\"1\" subClass=\"VRTRawRasterBand\">" +
         band + "<SourceFilename relativeToVRT=\"1\">data.bin</SourceFilename>" +
         "<ImageOffset>0</ImageOffset><PixelOffset>" + pixel + "</PixelOffset><LineOffset>" + line +
         "</LineOffset><ByteOrder>LSB</ByteOrder></VRTRasterBand></VRTDataset>";
}

template <class T>
std::string bytes_of_values(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

inline const std::string north_up = "<GeoTransform>100, 10, 0, 50, 0, -5</GeoTransform>";

/// The heights of a raster of such values.
template <class T>
HeightGrid read_values(const std::string& type, const std::vector<T>& values,
                       const std::string& band, const std::string& georeference = north_up,
                       const HeightGridOptions& options = {}) {
  const ScratchFolder folder;
  folder.put("data.bin", bytes_of_values(values));
  return read_height_grid(folder.put("a.vrt", vrt(type, sizeof(T), georeference, band)), options);
}

inline std::vector<double> values_of(const HeightGrid& grid) {
  std::vector<double> values;
  for (std::size_t i = 0; i < grid.heights.size(); ++i) values.push_back(grid.heights[i]);
  return values;
}

}  // namespace lepp::test
