#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "lepp/io/input_file.hpp"
#include "lepp/terrain/height_grid.hpp"

namespace lepp {

enum class SampleType { u8, i8, u16, i16, u32, i32, u64, i64, f32, f64 };

std::size_t bytes_of(SampleType type);
/// True if each value of the type is a float.
bool gives_floats(SampleType type);

/// Where the samples of a binary raster are in its file, and in which form.
struct RasterLayout {
  std::uint64_t offset = 0;
  SampleType type = SampleType::f32;
  bool big_endian = false;
  bool by_columns = false;  ///< column after column instead of row after row
  std::optional<double> nodata;
};

/// What the header of a binary raster says; the grid has no heights yet.
struct BinaryRaster {
  HeightGrid grid;
  RasterLayout layout;
};

// One function per format. Each returns nothing if the file is of another one.
// \throw InputError  a header that makes no sense, or that the size of the file contradicts
std::optional<BinaryRaster> f32_header(const InputFile& file);
std::optional<BinaryRaster> npy_header(const InputFile& file);
std::optional<BinaryRaster> pgm_header(const InputFile& file);  // P5 alone
std::optional<BinaryRaster> stm_header(const InputFile& file);

/// Sets the size of a grid. \throw InputError  not between 1 and 2^28
void set_size(HeightGrid& grid, double columns, double rows);

/// \throw InputError  the file has less, or more, than the samples of the grid behind the offset
void check_bytes(const InputFile& file, const BinaryRaster& raster);

/// The grid of a window, without heights. \throw InputError  the window is empty or sticks out
HeightGrid grid_of_window(const HeightGrid& whole, const GridWindow& window);

/// Asked before the heights of a grid are read, as floats, and before more heights come that may
/// make doubles of all. \throw RefusedError  they take more memory than the machine has
void check_memory(const HeightGrid& grid);
void check_memory(const HeightGrid& grid, std::span<const double> more);
inline void check_memory(const HeightGrid&, std::span<const float>) {}

/// Reads the heights of a window, and nothing else of the file. `grid` is grid_of_window().
/// \throw InputError  naming a height that is infinite, larger than 1.6e60 or an integer of more
///                    than 53 bits
/// \throw RefusedError  more memory than the machine has
/// Cost   one pass; memory for the heights and about a MiB
void read_samples(const InputFile& file, const BinaryRaster& whole, const GridWindow& window,
                  HeightGrid& grid);

}  // namespace lepp
