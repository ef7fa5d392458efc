#include "lepp/io/height_grid_read.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <variant>

#include "lepp/geometry/error.hpp"
#include "lepp/io/input_file.hpp"
#include "lepp/io/text_file.hpp"
#include "lepp/io/text_grid.hpp"

namespace lepp {

namespace {

namespace fs = std::filesystem;
using Raster = std::variant<BinaryRaster, TextRaster>;

std::string extension_of(const fs::path& path) {
  std::string text = path.extension().string();
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool looks_like_asc(const InputFile& file, const fs::path& path) {
  std::string head = file.head(64);
  std::ranges::transform(head, head.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const char* key : {"ncols", "nrows", "xllc", "yllc", "cellsize", "nodata_value"}) {
    if (head.starts_with(key)) return true;
  }
  return extension_of(path) == ".asc";
}

// The coordinate system beside an ESRI ASCII grid.
void read_prj(const fs::path& path, HeightGrid& grid) {
  constexpr std::uint64_t most = 1 << 16;
  fs::path beside = path;
  beside.replace_extension(".prj");
  std::error_code error;
  if (!fs::is_regular_file(beside, error) || fs::file_size(beside, error) == 0) return;
  std::string text = read_text_file(beside, most).text;
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  for (const char* geographic : {"GEOGCS[", "GEOGCRS[", "GEODCRS["}) {
    if (text.starts_with(geographic)) grid.degrees = true;
  }
  if (text.find('[') != text.npos) grid.crs = std::move(text);
}

Raster read_header(const InputFile& file, const fs::path& path) {
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
    if (extension_of(path) != known) continue;
    throw InputError(file.name(), std::string("does not begin as a ") + known + " file does",
                     "export it again, or name it after what it is");
  }
  throw InputError(file.name(), "is no height grid in a form known here",
                   "give .asc, .stm, .pgm, .npy or .f32");
}

void apply(const HeightGridOptions& options, HeightGrid& grid) {
  if (options.cell) {
    const auto [width, height] = *options.cell;
    if (!(width > 0 && height > 0 && std::isfinite(width) && std::isfinite(height)))
      throw InputError("the cell size", "is not above 0", "give width and height of a cell");
    grid.cell_width = width;
    grid.cell_height = height;
  } else if (grid.degrees) {
    set_cell_from_degrees(grid);
  } else if (grid.georeferenced) {
    grid.cell_width = grid.step_x;
    grid.cell_height = std::abs(grid.step_y);
  }
  if (grid.georeferenced) return;
  grid.step_x = grid.cell_width;
  grid.step_y = -grid.cell_height;
  grid.origin = {0, double(grid.rows - 1) * grid.cell_height};
}

HeightGrid& header_of(Raster& raster) {
  return std::visit([](auto& r) -> HeightGrid& { return r.grid; }, raster);
}

Raster open(const InputFile& file, const fs::path& path, const HeightGridOptions& options) {
  Raster raster = read_header(file, path);
  apply(options, header_of(raster));
  if (options.nodata) {
    if (auto* binary = std::get_if<BinaryRaster>(&raster)) binary->layout.nodata = options.nodata;
    else std::get<TextRaster>(raster).nodata = options.nodata;
  }
  return raster;
}

HeightGrid read(const InputFile& file, const Raster& raster, const GridWindow& window) {
  if (const auto* binary = std::get_if<BinaryRaster>(&raster)) {
    HeightGrid grid = grid_of_window(binary->grid, window);
    read_samples(file, *binary, window, grid);
    return grid;
  }
  const auto& text = std::get<TextRaster>(raster);
  HeightGrid grid = grid_of_window(text.grid, window);
  read_text_heights(file, text, window, grid);
  return grid;
}

}  // namespace

HeightGrid read_height_grid_header(const fs::path& path, const HeightGridOptions& options) {
  const InputFile file(path);
  Raster raster = open(file, path, options);
  return std::move(header_of(raster));
}

HeightGrid read_height_window(const fs::path& path, const GridWindow& window,
                              const HeightGridOptions& options) {
  const InputFile file(path);
  return read(file, open(file, path, options), window);
}

HeightGrid read_height_grid(const fs::path& path, const HeightGridOptions& options) {
  const InputFile file(path);
  Raster raster = open(file, path, options);
  const HeightGrid& header = header_of(raster);
  HeightGrid grid = read(file, raster, {0, 0, header.columns, header.rows});
  check_usable(grid);
  return grid;
}

void check_usable(const HeightGrid& grid) {
  if (grid.columns < 2 || grid.rows < 2) {
    throw InputError(grid.source,
                     "a grid of " + std::to_string(grid.columns) + " x " +
                         std::to_string(grid.rows) + " samples has no area between them",
                     "give at least two columns and two rows");
  }
  if (std::ranges::any_of(grid.heights, [](float h) { return !std::isnan(h); })) return;
  throw InputError(grid.source, "all " + std::to_string(grid.size()) + " samples are without data",
                   "check the value that means no data");
}

}  // namespace lepp
