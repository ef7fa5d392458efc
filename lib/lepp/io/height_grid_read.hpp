#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "lepp/io/gdal_options.hpp"
#include "lepp/io/grid_placement.hpp"
#include "lepp/terrain/grid_part.hpp"
#include "lepp/terrain/height_grid.hpp"

namespace lepp {

struct HeightGridOptions {
  /// Where the file has no georeference: the distances between columns and between rows; row 0 is
  /// the northern one and the last row lies at y = 0. Where it has one: the true size of a cell in
  /// the unit of the heights, for angles and slopes, in place of what the georeference says.
  std::optional<CellSize> cell = {};
  /// The value that means no data, in place of what the file declares: one of the file, as it is
  /// before scale and offset.
  std::optional<double> nodata = {};
  GdalOptions gdal = {};
};

/// Reads a height grid: ESRI ASCII (.asc), STM, PGM (P2 and P5), NPY, F32; each is known by how it
/// begins, ESRI ASCII by its name or its first word. All other files go to the separate program
/// lepp-gdal: GeoTIFF and everything else that GDAL reads, band 1, with scale and offset, declared
/// values of no data and masks applied; north-up or south-up, not rotated.
/// Heights are those of the file, whatever their type: of Float64 or wide integers, of text and of
/// scaled bands too (Heights). A value means no data if it is the declared one in the file's type.
/// \throw InputError   naming the file, and the line or the place in it; also of a height beyond
///                     1.6e60, of a 64-bit integer beyond 2^53, and of coordinates or cells that
///                     cannot hold a mesh (grid_placement.hpp)
/// \throw RefusedError more than the memory of this machine
/// Cost   one pass; memory for the heights, 4 bytes each if all are floats, else 8, and about a
///        MiB. Nothing is allocated for heights that the file is too short to hold.
HeightGrid read_height_grid(const std::filesystem::path& path,
                            const HeightGridOptions& options = {});

/// The same without heights: size and georeference.
HeightGrid read_height_grid_header(const std::filesystem::path& path,
                                   const HeightGridOptions& options = {});

/// A part of a grid; its georeference is its own, the size of its cells that of the whole grid, so
/// that neighbours match. It may be without any data. Of binary formats only the part is read; text
/// is passed to its end. For many parts of one file: HeightGridFile.
HeightGrid read_height_window(const std::filesystem::path& path, const GridWindow& window,
                              const HeightGridOptions& options = {});

/// The same with what lies one step around it, for tiles.
/// \param whole  read_height_grid_header() of the file
GridPart read_grid_part(const std::filesystem::path& path, const HeightGrid& whole,
                        const GridWindow& window, const HeightGridOptions& options = {});

/// A grid file that stays open, to be read part by part, neighbours one after the other.
///
/// Of binary formats each part is read alone. A text file is passed to its end once, at the first
/// part; later ones begin near their first row. And where a part of a row costs as much as all of
/// it, in text and for lepp-gdal, up to 2^24 samples of whole rows are kept for the parts beside.
class HeightGridFile {
 public:
  /// \throw InputError  as read_height_grid()
  explicit HeightGridFile(const std::filesystem::path& path, const HeightGridOptions& options = {});
  HeightGridFile(const HeightGridFile&) = delete;
  HeightGridFile& operator=(const HeightGridFile&) = delete;
  ~HeightGridFile();

  /// The grid without heights.
  const HeightGrid& whole() const;
  /// As read_height_window(). \throw InputError  also if the file has become shorter
  HeightGrid read(const GridWindow& window);
  /// As read_grid_part().
  GridPart read_part(const GridWindow& window);

 private:
  class Reader;
  std::unique_ptr<Reader> reader_;
};

/// The window in parts of whole rows, in order, each of some 2^22 samples: to look at all heights
/// of a grid in little memory.
std::vector<GridWindow> bands_of(const GridWindow& window);

}  // namespace lepp
