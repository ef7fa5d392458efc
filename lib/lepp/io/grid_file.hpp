#pragma once

#include <filesystem>
#include <optional>
#include <variant>

#include "lepp/io/height_grid_read.hpp"
#include "lepp/io/input_file.hpp"
#include "lepp/io/text_grid.hpp"

namespace lepp {

/// A file of heights, opened: its form is known, and it is read in every way.
class GridFile {
 public:
  /// Of another format, that GDAL may know.
  struct OfGdal {};
  using Raster = std::variant<BinaryRaster, TextRaster, OfGdal>;

  /// \throw InputError  of no known form, or its header makes no sense
  GridFile(const std::filesystem::path& path, const HeightGridOptions& options);

  /// The grid without heights.
  HeightGrid header() const;
  /// \param window  nothing: all of it
  HeightGrid read(const std::optional<GridWindow>& window);
  /// True if a window is read for what it costs itself, wherever it lies.
  bool is_binary() const { return std::holds_alternative<BinaryRaster>(raster_); }

 private:
  const std::filesystem::path path_;
  const HeightGridOptions options_;
  const InputFile file_;
  Raster raster_;
  TextRows rows_;
};

}  // namespace lepp
