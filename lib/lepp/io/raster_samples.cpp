#include <algorithm>
#include <array>
#include <vector>

#include "lepp/io/raster_layout.hpp"
#include "lepp/io/sample_values.hpp"

namespace lepp {

namespace {

constexpr std::size_t samples_at_once = std::size_t{1} << 17;  // a buffer that caches hold

// Height: Height  float if each value of the file's type is one, else double
template <class Height>
class SampleReader {
 public:
  SampleReader(const InputFile& file, const BinaryRaster& whole, const GridWindow& window,
               HeightGrid& grid)
      : file_(file),
        layout_(whole.layout),
        window_(window),
        grid_(grid),
        sample_bytes_(bytes_of(layout_.type)),
        // Rows are numbered as lines of the file: its columns where it goes by columns.
        line_length_(layout_.by_columns ? whole.grid.rows : whole.grid.columns),
        nodata_(layout_.nodata) {}

  void run() {
    if (layout_.by_columns) read_columns();
    else if (window_.columns == line_length_) read_run();
    else read_rows();
  }

 private:
  std::uint64_t place(std::uint64_t line, std::uint64_t along) const {
    return layout_.offset + (line * line_length_ + along) * sample_bytes_;
  }

  // Converts what lies from `place` on.
  void read(std::uint64_t place, std::span<Height> heights) {
    buffer_.resize(heights.size() * sample_bytes_);
    file_.read_all(place, buffer_);
    convert_samples(layout_, nodata_, buffer_, heights);
  }

  // The next `count` heights of the grid.
  void append(std::uint64_t place, std::size_t count) {
    const std::size_t first = grid_.heights.size();
    heights_.resize(count);
    read(place, heights_);
    if (const auto i = first_unusable(std::span<const Height>(heights_))) {
      refuse_height(grid_.source, window_.column + (first + *i) % window_.columns,
                    window_.row + (first + *i) / window_.columns);
    }
    check_memory(grid_, std::span<const Height>(heights_));
    grid_.heights.append(std::span<const Height>(heights_));
  }

  void read_run() {
    grid_.heights.reserve(grid_.size());
    while (grid_.heights.size() < grid_.size()) {
      const std::size_t done = grid_.heights.size();
      append(place(window_.row, done), std::min(samples_at_once, grid_.size() - done));
    }
  }

  void read_rows() {
    grid_.heights.reserve(grid_.size());
    for (std::uint32_t row = 0; row < window_.rows; ++row) {
      for (std::uint32_t done = 0; done < window_.columns;) {
        const auto count = std::min<std::size_t>(samples_at_once, window_.columns - done);
        append(place(window_.row + row, window_.column + done), count);
        done += static_cast<std::uint32_t>(count);
      }
    }
  }

  // Some columns at a time, so that each line of the cache that is written to gets them all.
  void read_columns() {
    grid_.heights.resize(grid_.size());
    const std::size_t most = std::clamp<std::size_t>(samples_at_once / window_.rows, 1, 64);
    for (std::uint32_t first = 0; first < window_.columns;) {
      const auto count =
          static_cast<std::uint32_t>(std::min<std::size_t>(most, window_.columns - first));
      read_strip(first, count);
      std::array<Height, 64> along;  // a row of the strip
      for (std::uint32_t row = 0; row < window_.rows; ++row) {
        for (std::uint32_t k = 0; k < count; ++k)
          along[k] = heights_[std::size_t{k} * window_.rows + row];
        check_memory(grid_, std::span<const Height>(along).first(count));
        grid_.heights.assign(grid_.index(first, row), std::span<const Height>(along).first(count));
      }
      first += count;
    }
  }

  void read_strip(std::uint32_t first, std::uint32_t count) {
    heights_.resize(std::size_t{count} * window_.rows);
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto column = std::span(heights_).subspan(std::size_t{k} * window_.rows, window_.rows);
      read(place(window_.column + first + k, window_.row), column);
      if (const auto row = first_unusable(std::span<const Height>(column)))
        refuse_height(grid_.source, window_.column + first + k, window_.row + *row);
    }
  }

  const InputFile& file_;
  const RasterLayout& layout_;
  const GridWindow window_;
  HeightGrid& grid_;
  const std::size_t sample_bytes_;
  const std::uint64_t line_length_;
  const NodataRange nodata_;
  std::vector<std::byte> buffer_;
  std::vector<Height> heights_;
};

}  // namespace

void read_samples(const InputFile& file, const BinaryRaster& whole, const GridWindow& window,
                  HeightGrid& grid) {
  check_memory(grid);
  if (gives_floats(whole.layout.type)) SampleReader<float>(file, whole, window, grid).run();
  else SampleReader<double>(file, whole, window, grid).run();
}

}  // namespace lepp
