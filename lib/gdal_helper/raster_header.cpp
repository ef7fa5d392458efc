#include "raster_header.hpp"

#include <ogr_spatialref.h>

#include <cmath>
#include <vector>

#include "gdal_failure.hpp"
#include "lepp/geometry/text.hpp"

namespace lepp::gdal_helper {

namespace {

void read_geotransform(GDALDataset& dataset, GdalRaster& raster) {
  double g[6];
  if (dataset.GetGeoTransform(g) != CE_None) return;
  if (g[2] != 0 || g[4] != 0) {
    throw GdalFailure{ErrorKind::input, "",
                      "its rows and columns are rotated against its coordinates",
                      "straighten it with gdalwarp"};
  }
  if (!(g[1] > 0) || g[5] == 0 || !std::isfinite(g[1]) || !std::isfinite(g[5])) {
    throw GdalFailure{ErrorKind::input, "", "its columns do not run from west to east",
                      "turn it round with gdalwarp"};
  }
  raster.georeferenced = true;
  raster.step_x = g[1];
  raster.step_y = g[5];
  raster.origin = {g[0] + g[1] / 2, g[3] + g[5] / 2};
}

void read_crs(GDALDataset& dataset, GdalRaster& raster) {
  const OGRSpatialReference* crs = dataset.GetSpatialRef();
  if (crs == nullptr || !raster.georeferenced) return;
  raster.crs = wkt_of(*crs);
  if (!crs->IsGeographic()) return;
  const double radians = crs->GetAngularUnits(nullptr);
  raster.degrees = std::abs(radians * 180 / M_PI - 1) < 1e-9;
  if (!raster.degrees)
    raster.warnings.push_back("its angles are not in degrees, so cells are taken as they are");
}

// Names of parts without end are left out: a record has a limit.
std::vector<std::string> files_of(GDALDataset& dataset) {
  constexpr std::size_t most_bytes = std::size_t{1} << 25;
  std::vector<std::string> files;
  std::size_t bytes = 0;
  char** const list = dataset.GetFileList();
  for (char** name = list; name != nullptr && *name != nullptr; ++name) {
    files.emplace_back(*name);
    bytes += files.back().size() + sizeof(std::uint64_t);
    if (bytes > most_bytes) break;
  }
  CSLDestroy(list);
  return files;
}

// True if each height is a float whatever the values are.
bool gives_floats(GDALRasterBand& band) {
  const GDALDataType type = band.GetRasterDataType();
  return scaling_of(band).is_none() && (GDALGetDataTypeSizeBytes(type) <= 2 || type == GDT_Float32);
}

}  // namespace

Dataset open_raster(const std::string& file) {
  CPLErrorReset();
  Dataset dataset(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
  if (!dataset)
    throw GdalFailure{ErrorKind::input, "", said("is no raster that GDAL reads"),
                      "give a raster file; gdalinfo shows what GDAL makes of it"};
  if (dataset->GetRasterCount() < 1) {
    throw GdalFailure{ErrorKind::input, "", "has no band of its own, only parts with names",
                      "extract one with gdal_translate; gdalinfo lists them"};
  }
  return dataset;
}

GdalRaster header_of(GDALDataset& dataset) {
  GdalRaster raster;
  raster.columns = static_cast<std::uint32_t>(dataset.GetRasterXSize());
  raster.rows = static_cast<std::uint32_t>(dataset.GetRasterYSize());
  read_geotransform(dataset, raster);
  read_crs(dataset, raster);
  raster.files = files_of(dataset);
  if (const int bands = dataset.GetRasterCount(); bands > 1)
    raster.warnings.push_back("has " + std::to_string(bands) +
                              " bands; band 1 is taken as heights");
  if (GDALDataTypeIsComplex(dataset.GetRasterBand(1)->GetRasterDataType()))
    throw GdalFailure{ErrorKind::input, "", "its values are complex numbers",
                      "give a raster of heights"};
  raster.doubles = !gives_floats(*dataset.GetRasterBand(1));
  return raster;
}

Scaling scaling_of(GDALRasterBand& band) {
  Scaling scaling;
  int has = 0;
  if (const double scale = band.GetScale(&has); has != 0) scaling.scale = scale;
  if (const double offset = band.GetOffset(&has); has != 0) scaling.offset = offset;
  return scaling;
}

void warn_of_scaling(GDALRasterBand& band, GdalRaster& raster) {
  const Scaling scaling = scaling_of(band);
  if (scaling.is_none()) return;
  raster.warnings.push_back(
      "the value of no data that was given is compared with its values before "
      "its scale of " +
      to_text(scaling.scale) + " and offset of " + to_text(scaling.offset));
}

}  // namespace lepp::gdal_helper
