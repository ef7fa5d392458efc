#include "lepp/io/grid_file.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/io/crs_wkt.hpp"
#include "lepp/io/file_kind.hpp"
#include "lepp/io/gdal_process.hpp"
#include "lepp/io/raster_layout.hpp"
#include "lepp/io/text_file.hpp"

namespace lepp {

namespace {

namespace fs = std::filesystem;

bool looks_like_asc(const InputFile& file, const fs::path& path) {
  const std::string head = lower_case(file.head(64));
  for (const char* key : {"ncols", "nrows", "xllc", "yllc", "cellsize", "nodata_value"}) {
    if (head.starts_with(key)) return true;
  }
  return file_kind(path) == ".asc";
}

// The coordinate system beside an ESRI ASCII grid.
void read_prj(const fs::path& path, HeightGrid& grid) {
  constexpr std::uint64_t most = 1 << 16;
  fs::path beside = path;
  beside.replace_extension(".prj");
  std::error_code error;
  if (!fs::is_regular_file(beside, error) || fs::file_size(beside, error) == 0) return;
  grid.files.push_back(beside.string());
  std::string text = read_text_file(beside, most).text;
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  const CrsWkt crs = parse_crs_wkt(text);
  constexpr double degree = std::numbers::pi / 180;
  grid.degrees = crs.is_geographic && std::abs(crs.unit.value_or(degree) / degree - 1) < 1e-9;
  if (crs.is_geographic && !grid.degrees) {
    grid.warnings.push_back(grid.source +
                            ": its angles are not in degrees, so cells are taken as they are");
  }
  if (text.find('[') != text.npos) grid.crs = std::move(text);
}

GridFile::Raster read_header(const InputFile& file, const fs::path& path) {
  if (file.size() == 0) throw InputError(file.name(), "the file is empty", "give a file with data");
  using Reader = std::optional<BinaryRaster> (*)(const InputFile&);
  for (const Reader reader :
       {Reader(f32_header), Reader(npy_header), Reader(pgm_header), Reader(stm_header)}) {
    if (auto raster = reader(file)) return *std::move(raster);
  }
  if (auto raster = plain_pgm_header(file)) return *std::move(raster);
  if (looks_like_asc(file, path)) {
    TextRaster raster = asc_header(file);
    read_prj(path, raster.grid);
    return raster;
  }
  for (const char* known : {".f32", ".npy", ".pgm", ".stm"}) {
    if (file_kind(path) != known) continue;
    throw InputError(file.name(), std::string("does not begin as a ") + known + " file does",
                     "export it again, or name it after what it is");
  }
  return GridFile::OfGdal{};
}

void set_nodata(GridFile::Raster& raster, double nodata) {
  if (auto* binary = std::get_if<BinaryRaster>(&raster)) binary->layout.nodata = nodata;
  if (auto* text = std::get_if<TextRaster>(&raster)) text->nodata = nodata;
}

}  // namespace

GridFile::GridFile(const fs::path& path, const HeightGridOptions& options)
    : path_(path), options_(options), file_(path), raster_(read_header(file_, path)) {
  if (options.nodata) set_nodata(raster_, *options.nodata);
  if (auto* binary = std::get_if<BinaryRaster>(&raster_)) place_grid(options.cell, binary->grid);
  if (auto* text = std::get_if<TextRaster>(&raster_)) place_grid(options.cell, text->grid);
}

HeightGrid GridFile::header() const {
  if (const auto* binary = std::get_if<BinaryRaster>(&raster_)) return binary->grid;
  if (const auto* text = std::get_if<TextRaster>(&raster_)) return text->grid;
  HeightGrid grid = read_gdal_header(path_, options_.nodata, options_.gdal);
  place_grid(options_.cell, grid);
  return grid;
}

HeightGrid GridFile::read(const std::optional<GridWindow>& window) {
  if (std::holds_alternative<OfGdal>(raster_)) {
    const auto prepare = [&](HeightGrid& whole) { place_grid(options_.cell, whole); };
    return read_gdal_heights(path_, window, options_.nodata, prepare, options_.gdal);
  }
  const HeightGrid whole = header();
  const GridWindow part = window.value_or(GridWindow{0, 0, whole.columns, whole.rows});
  HeightGrid grid = grid_of_window(whole, part);
  if (const auto* binary = std::get_if<BinaryRaster>(&raster_))
    read_samples(file_, *binary, part, grid);
  else read_text_heights(file_, std::get<TextRaster>(raster_), part, grid, rows_);
  return grid;
}

}  // namespace lepp
