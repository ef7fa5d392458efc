#pragma once

#include <gdal_priv.h>

#include <memory>
#include <string>

#include "lepp/io/gdal_record.hpp"

namespace lepp::gdal_helper {

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

/// \throw GdalFailure  where GDAL finds no raster in it
Dataset open_raster(const std::string& file);

/// All but heights. \throw GdalFailure  where lepp has no use for it
GdalRaster header_of(GDALDataset& dataset);

/// What a band's values have to be multiplied with, and then raised by.
struct Scaling {
  double scale = 1, offset = 0;
  bool is_none() const { return scale == 1 && offset == 0; }
};

Scaling scaling_of(GDALRasterBand& band);

/// The user's value of no data is compared with those of the file, as GDAL has it, not with
/// heights.
void warn_of_scaling(GDALRasterBand& band, GdalRaster& raster);

}  // namespace lepp::gdal_helper
