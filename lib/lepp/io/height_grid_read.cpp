#include "lepp/io/height_grid_read.hpp"

#include <algorithm>

#include "lepp/io/grid_file.hpp"
#include "lepp/io/raster_layout.hpp"

namespace lepp {

namespace fs = std::filesystem;

namespace {

// A window and one step around it, as far as the whole goes; and the window in that.
struct Surroundings {
  GridWindow all, inner;
};

Surroundings surroundings_of(const HeightGrid& whole, const GridWindow& window) {
  grid_of_window(whole, window);  // throws if it sticks out
  const std::uint32_t west = window.column > 0 ? 1 : 0, above = window.row > 0 ? 1 : 0;
  const std::uint32_t east = window.column + window.columns < whole.columns ? 1 : 0;
  const std::uint32_t below = window.row + window.rows < whole.rows ? 1 : 0;
  return {{window.column - west, window.row - above, window.columns + west + east,
           window.rows + above + below},
          {west, above, window.columns, window.rows}};
}

// Whole rows from `first_row` of a file on, of which some are wanted.
HeightGrid cut(const HeightGrid& rows, std::uint32_t first_row, const HeightGrid& whole,
               const GridWindow& window) {
  HeightGrid grid = grid_of_window(whole, window);
  grid.heights.reserve(grid.size());
  for (std::uint32_t row = 0; row < window.rows; ++row) {
    const std::size_t first = rows.index(window.column, window.row + row - first_row);
    rows.heights.visit([&](auto all) { grid.heights.append(all.subspan(first, window.columns)); });
  }
  return grid;
}

}  // namespace

class HeightGridFile::Reader {
 public:
  Reader(const fs::path& path, const HeightGridOptions& options)
      : file_(path, options), whole_(file_.header()) {}

  const HeightGrid& whole() const { return whole_; }

  HeightGrid read(const GridWindow& window) {
    if (!keeps_rows_of(window)) return file_.read(window);
    if (!has_rows_of(window)) {
      rows_ = {};  // before the next ones take memory
      rows_ = file_.read(GridWindow{0, window.row, whole_.columns, window.rows});
      first_row_ = window.row;
    }
    return cut(rows_, first_row_, whole_, window);
  }

 private:
  // To read a part of a row of these files costs as much as all of it.
  bool keeps_rows_of(const GridWindow& window) const {
    constexpr std::uint64_t most_samples = std::uint64_t{1} << 24;
    grid_of_window(whole_, window);  // throws if it sticks out
    return !file_.is_binary() && window.columns < whole_.columns &&
           std::uint64_t{window.rows} * whole_.columns <= most_samples;
  }
  bool has_rows_of(const GridWindow& window) const {
    return window.row >= first_row_ && window.row - first_row_ < rows_.rows &&
           window.rows <= rows_.rows - (window.row - first_row_);
  }

  GridFile file_;
  const HeightGrid whole_;
  HeightGrid rows_;  // all columns, from first_row_ on
  std::uint32_t first_row_ = 0;
};

HeightGridFile::HeightGridFile(const fs::path& path, const HeightGridOptions& options)
    : reader_(std::make_unique<Reader>(path, options)) {}
HeightGridFile::~HeightGridFile() = default;

const HeightGrid& HeightGridFile::whole() const { return reader_->whole(); }

HeightGrid HeightGridFile::read(const GridWindow& window) { return reader_->read(window); }

GridPart HeightGridFile::read_part(const GridWindow& window) {
  const auto [all, inner] = surroundings_of(whole(), window);
  return part_of(read(all), inner);
}

std::vector<GridWindow> bands_of(const GridWindow& window) {
  constexpr std::uint32_t samples = std::uint32_t{1} << 22;
  const std::uint32_t most = std::max(samples / std::max(window.columns, 1U), 1U);
  std::vector<GridWindow> bands;
  for (std::uint32_t done = 0; done < window.rows; done += bands.back().rows) {
    bands.push_back(
        {window.column, window.row + done, window.columns, std::min(most, window.rows - done)});
  }
  return bands;
}

HeightGrid read_height_grid_header(const fs::path& path, const HeightGridOptions& options) {
  return GridFile(path, options).header();
}

HeightGrid read_height_window(const fs::path& path, const GridWindow& window,
                              const HeightGridOptions& options) {
  return GridFile(path, options).read(window);
}

HeightGrid read_height_grid(const fs::path& path, const HeightGridOptions& options) {
  HeightGrid grid = GridFile(path, options).read(std::nullopt);
  check_usable(grid);
  return grid;
}

GridPart read_grid_part(const fs::path& path, const HeightGrid& whole, const GridWindow& window,
                        const HeightGridOptions& options) {
  const auto [all, inner] = surroundings_of(whole, window);
  return part_of(read_height_window(path, all, options), inner);
}

}  // namespace lepp
