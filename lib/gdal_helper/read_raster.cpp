#include "read_raster.hpp"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "gdal_failure.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/io/sample_values.hpp"
#include "pipe.hpp"

namespace lepp::gdal_helper {
namespace {

constexpr std::size_t samples_at_once = std::size_t{1} << 20;
constexpr std::size_t most_samples_at_once = std::size_t{1} << 26;

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

Dataset open(const std::string& file) {
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

// What a band's values have to be multiplied with, and then raised by.
struct Scaling {
  double scale = 1, offset = 0;
  bool is_none() const { return scale == 1 && offset == 0; }
};

Scaling scaling_of(GDALRasterBand& band) {
  Scaling scaling;
  int has = 0;
  if (const double scale = band.GetScale(&has); has != 0) scaling.scale = scale;
  if (const double offset = band.GetOffset(&has); has != 0) scaling.offset = offset;
  return scaling;
}

// Its values of no data are those of the file, as GDAL has it, not heights.
void warn_of_scaling(GDALRasterBand& band, GdalRaster& raster) {
  const Scaling scaling = scaling_of(band);
  if (scaling.is_none()) return;
  raster.warnings.push_back(
      "the value of no data that was given is compared with its values before "
      "its scale of " +
      to_text(scaling.scale) + " and offset of " + to_text(scaling.offset));
}

// True if each height is a float whatever the values are.
bool gives_floats(GDALRasterBand& band) {
  const GDALDataType type = band.GetRasterDataType();
  return scaling_of(band).is_none() && (GDALGetDataTypeSizeBytes(type) <= 2 || type == GDT_Float32);
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

// The value that the band itself declares.
std::optional<double> declared_nodata(GDALRasterBand& band) {
  int has = 0;
  double value = 0;
  switch (band.GetRasterDataType()) {
    case GDT_Int64:
      value = static_cast<double>(band.GetNoDataValueAsInt64(&has));
      break;
    case GDT_UInt64:
      value = static_cast<double>(band.GetNoDataValueAsUInt64(&has));
      break;
    default:
      value = band.GetNoDataValue(&has);
  }
  return has != 0 ? std::optional(value) : std::nullopt;
}

// Band 1, block after block, as floats or doubles.
template <class Height>
class HeightSender {
 public:
  HeightSender(GDALDataset& dataset, const GridWindow& window, const RasterTask& task)
      : band_(*dataset.GetRasterBand(1)),
        window_(window),
        memory_bytes_(task.memory_bytes),
        nodata_(task.nodata ? task.nodata : declared_nodata(band_)),
        scaling_(scaling_of(band_)) {
    masked_ = has_mask(task.nodata.has_value());
  }

  void run() {
    GdalRasterEnd end;
    try {
      send_blocks();
    } catch (const GdalFailure& failure) {
      end.failure = failure;
    } catch (const std::bad_alloc&) {
      end.failure = out_of_memory(memory_bytes_);
    }
    const std::uint32_t no_more = 0;
    send(std::as_bytes(std::span(&no_more, 1)));
    send(encode(end));
  }

 private:
  // A mask that says more than declared_nodata(): one of the band, of the data set, or made of an
  // alpha band or of values of no data for all bands. The last are declared too, and give way.
  bool has_mask(bool has_own_nodata) const {
    const int flags = band_.GetMaskFlags();
    if ((flags & GMF_ALL_VALID) != 0) return false;
    if ((flags & GMF_NODATA) == 0) return true;
    return (flags & GMF_PER_DATASET) != 0 && !has_own_nodata;
  }

  // Whole blocks of the file, so that none is read twice, unless they are huge: some files are one
  // block.
  std::uint32_t rows_at_once() const {
    int width = 0, height = 0;
    band_.GetBlockSize(&width, &height);
    const auto block = static_cast<std::size_t>(std::max(height, 1));
    const std::size_t blocks = samples_at_once / (block * window_.columns);
    const std::size_t most = std::max<std::size_t>(most_samples_at_once / window_.columns, 1);
    return static_cast<std::uint32_t>(
        std::min<std::size_t>({block * std::max<std::size_t>(blocks, 1), most, window_.rows}));
  }

  void send_blocks() {
    const std::uint32_t most = rows_at_once();
    for (std::uint32_t row = 0; row < window_.rows;) {
      // The first block ends where a block of the file does.
      const std::uint32_t ragged = (window_.row + row) % most;
      const std::uint32_t rows = std::min(most - ragged, window_.rows - row);
      read(row, rows);
      send(std::as_bytes(std::span(&rows, 1)));
      send(std::as_bytes(std::span(heights_)));
      row += rows;
    }
  }

  void read(std::uint32_t row, std::uint32_t rows) {
    heights_.resize(std::size_t{rows} * window_.columns);
    switch (band_.GetRasterDataType()) {
      case GDT_Float32:
        read_as<float>(row, rows, GDT_Float32);
        break;
      case GDT_Int64:
        read_as<std::int64_t>(row, rows, GDT_Int64);
        break;
      case GDT_UInt64:
        read_as<std::uint64_t>(row, rows, GDT_UInt64);
        break;
      default:
        read_as<Height>(row, rows, sizeof(Height) == 4 ? GDT_Float32 : GDT_Float64);
    }
    if (masked_) apply_mask(row, rows);
    if (const auto i = first_unusable(std::span<const Height>(heights_))) {
      throw GdalFailure{ErrorKind::input,
                        "column " + std::to_string(window_.column + *i % window_.columns) +
                            ", row " + std::to_string(window_.row + row + *i / window_.columns),
                        unusable_height, unusable_height_remedy};
    }
  }

  // Values of the band, or at least in a type that holds each of them: no data is compared there.
  template <class Value>
  void read_as(std::uint32_t row, std::uint32_t rows, GDALDataType type) {
    if constexpr (std::is_same_v<Value, Height>) {
      transfer(band_, row, rows, heights_.data(), type);
      for (Height& h : heights_) h = height_of(h);
    } else if constexpr (sizeof(Value) <= sizeof(Height)) {
      std::vector<Value> values(heights_.size());
      transfer(band_, row, rows, values.data(), type);
      std::ranges::transform(values, heights_.begin(), [&](Value v) { return height_of(v); });
    }
  }

  template <class Value>
  Height height_of(Value value) const {
    if (nodata_.has(value)) return std::numeric_limits<Height>::quiet_NaN();
    if constexpr (std::is_same_v<Height, float>) return value;
    else if constexpr (std::is_integral_v<Value>) return scaled(height_of_integer(value));
    else return scaled(value);
  }
  double scaled(double value) const { return value * scaling_.scale + scaling_.offset; }

  void apply_mask(std::uint32_t row, std::uint32_t rows) {
    mask_.resize(heights_.size());
    transfer(*band_.GetMaskBand(), row, rows, mask_.data(), GDT_Byte);
    for (std::size_t i = 0; i < mask_.size(); ++i) {
      if (mask_[i] == 0) heights_[i] = std::numeric_limits<Height>::quiet_NaN();
    }
  }

  void transfer(GDALRasterBand& band, std::uint32_t row, std::uint32_t rows, void* to,
                GDALDataType type) const {
    const auto whole = [](std::uint32_t x) { return static_cast<int>(x); };
    CPLErrorReset();
    const CPLErr error = band.RasterIO(GF_Read, whole(window_.column), whole(window_.row + row),
                                       whole(window_.columns), whole(rows), to,
                                       whole(window_.columns), whole(rows), type, 0, 0, nullptr);
    if (error == CE_None) return;
    if (CPLGetLastErrorNo() == CPLE_OutOfMemory) throw out_of_memory(memory_bytes_);
    throw GdalFailure{ErrorKind::input, "rows from " + std::to_string(window_.row + row),
                      said("they cannot be read"), "the file is damaged: get it again"};
  }

  GDALRasterBand& band_;
  const GridWindow window_;
  const std::uint64_t memory_bytes_;
  const NodataRange nodata_;
  const Scaling scaling_;
  bool masked_ = false;
  std::vector<Height> heights_;
  std::vector<unsigned char> mask_;
};

}  // namespace

void send_raster(const RasterTask& task) {
  Dataset dataset;
  GdalRaster raster;
  try {
    dataset = open(task.file);
    raster = header_of(*dataset);
    if (task.nodata) warn_of_scaling(*dataset->GetRasterBand(1), raster);
    if (task.window &&
        (std::uint64_t{task.window->column} + task.window->columns > raster.columns ||
         std::uint64_t{task.window->row} + task.window->rows > raster.rows))
      throw GdalFailure{ErrorKind::input, "", "the window is not inside the raster",
                        "choose another window"};
  } catch (const GdalFailure& failure) {
    raster.failure = failure;
  } catch (const std::bad_alloc&) {
    raster.failure = out_of_memory(task.memory_bytes);
  }
  send(encode(raster));
  if (raster.failure || task.header_only) return;
  const GridWindow whole{0, 0, raster.columns, raster.rows};
  const GridWindow window = task.window.value_or(whole);
  if (raster.doubles) HeightSender<double>(*dataset, window, task).run();
  else HeightSender<float>(*dataset, window, task).run();
}

}  // namespace lepp::gdal_helper
