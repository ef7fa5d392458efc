#include "read_raster.hpp"

#include <algorithm>
#include <limits>
#include <new>
#include <span>
#include <type_traits>
#include <vector>

#include "gdal_failure.hpp"
#include "lepp/io/sample_values.hpp"
#include "pipe.hpp"
#include "raster_header.hpp"

namespace lepp::gdal_helper {
namespace {

constexpr std::size_t samples_at_once = std::size_t{1} << 20;
constexpr std::size_t most_samples_at_once = std::size_t{1} << 26;

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
                      said("they cannot be read"), remedy_for_reading()};
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
    dataset = open_raster(task.file);
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
