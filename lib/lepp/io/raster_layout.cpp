#include "lepp/io/raster_layout.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/text.hpp"

namespace lepp {

namespace {

void check_memory(const HeightGrid& grid, std::size_t bytes_of_height) {
  const double there = double(::sysconf(_SC_PHYS_PAGES)) * double(::sysconf(_SC_PAGE_SIZE));
  const double wanted = double(grid.size()) * double(bytes_of_height);
  if (wanted <= there) return;
  throw RefusedError(grid.source,
                     "its " + std::to_string(grid.columns) + " x " + std::to_string(grid.rows) +
                         " heights take " + to_text(std::ceil(wanted / 0x1p30)) +
                         " GiB, more than this machine has",
                     "read it in parts, with --tiles ROWSxCOLUMNS");
}

}  // namespace

std::size_t bytes_of(SampleType type) {
  switch (type) {
    case SampleType::u8:
    case SampleType::i8:
      return 1;
    case SampleType::u16:
    case SampleType::i16:
      return 2;
    case SampleType::u64:
    case SampleType::i64:
    case SampleType::f64:
      return 8;
    default:
      return 4;
  }
}

bool gives_floats(SampleType type) { return bytes_of(type) <= 2 || type == SampleType::f32; }

void set_size(HeightGrid& grid, double columns, double rows) {
  constexpr double most = 0x1p28;
  for (const auto& [what, count] : {std::pair("columns", columns), std::pair("rows", rows)}) {
    if (count >= 1 && count <= most && count == std::floor(count)) continue;
    throw InputError(grid.source, std::string("the number of ") + what + " is " + to_text(count),
                     "it must be a whole number from 1 to 268435456: export the file again");
  }
  grid.columns = static_cast<std::uint32_t>(columns);
  grid.rows = static_cast<std::uint32_t>(rows);
}

void check_bytes(const InputFile& file, const BinaryRaster& raster) {
  const auto there = file.size() - std::min(file.size(), raster.layout.offset);
  const std::uint64_t wanted = raster.grid.size() * bytes_of(raster.layout.type);
  if (there == wanted) return;
  throw InputError(file.name(),
                   "holds " + std::to_string(there) + " bytes of samples, but its header says " +
                       std::to_string(raster.grid.columns) + " x " +
                       std::to_string(raster.grid.rows) + " samples of " +
                       std::to_string(bytes_of(raster.layout.type)) + " bytes, that is " +
                       std::to_string(wanted),
                   there < wanted ? "the file is cut short: export it again"
                                  : "correct the header, or export the file again");
}

void check_memory(const HeightGrid& grid) { check_memory(grid, sizeof(float)); }

void check_memory(const HeightGrid& grid, std::span<const double> more) {
  if (grid.heights.are_floats() && !std::ranges::all_of(more, is_float))
    check_memory(grid, sizeof(double));
}

HeightGrid grid_of_window(const HeightGrid& whole, const GridWindow& window) {
  const bool fits = window.columns >= 1 && window.rows >= 1 && window.column < whole.columns &&
                    window.row < whole.rows && window.columns <= whole.columns - window.column &&
                    window.rows <= whole.rows - window.row;
  if (!fits) {
    throw InputError(whole.source,
                     "a window of " + std::to_string(window.columns) + " x " +
                         std::to_string(window.rows) + " samples from column " +
                         std::to_string(window.column) + ", row " + std::to_string(window.row) +
                         " is not inside its " + std::to_string(whole.columns) + " x " +
                         std::to_string(whole.rows),
                     "choose another window");
  }
  HeightGrid grid = whole;
  grid.columns = window.columns;
  grid.rows = window.rows;
  grid.origin.x += window.column * whole.step_x;
  grid.origin.y += window.row * whole.step_y;
  return grid;
}

}  // namespace lepp
