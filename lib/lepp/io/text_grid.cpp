#include "lepp/io/text_grid.hpp"

#include <cmath>

#include "lepp/geometry/error.hpp"

namespace lepp {

namespace {

// Numbered words behind a place where a row begins.
class TextHeights {
 public:
  TextHeights(const InputFile& file, const TextRaster& whole, const GridWindow& window,
              HeightGrid& grid, const TextPlace& begin, std::uint32_t row)
      : stream_(file, begin.offset, begin.line),
        whole_(whole),
        window_(window),
        grid_(grid),
        nodata_(whole.nodata),
        // A height takes two bytes, with what separates it from the next.
        room_(file.size() - whole.offset + 1 >= 2 * std::uint64_t{whole.grid.size()}),
        row_(row) {
    if (!room_) return;
    check_memory(grid_);
    grid_.heights.reserve(grid_.size());
  }

  // All of the file, checked, from its first row on.
  TextRows read_and_check() {
    constexpr std::uint32_t most_places = 4096;
    TextRows rows{whole_.grid.rows / most_places + 1, {}};
    line_ = whole_.line;
    for (std::string_view word; next(word);) {
      if (stream_.line() != line_) end_line();
      if (room_ && count_ < whole_.grid.size()) {
        if (column_ == 0 && row_ % rows.step == 0)
          rows.begins.push_back({stream_.offset(), stream_.line()});
        const double value = stream_.number(word);
        if (is_wanted()) store(value);
        step();
      }
      ++count_;
      ++on_line_;
    }
    end_line();
    check_count();
    return rows;
  }

  // The window alone.
  void read() {
    for (std::string_view word; row_ < window_.row + window_.rows && next(word); step()) {
      if (is_wanted()) store(stream_.number(word));
    }
    if (grid_.heights.size() == grid_.size()) return;
    throw InputError(grid_.source, "the file has become shorter while it was read",
                     "export it again, and wait for its end");
  }

 private:
  bool next(std::string_view& word) {
    while (stream_.next(word)) {
      if (!whole_.comments || !word.starts_with('#')) return true;
      stream_.skip_line();
    }
    return false;
  }

  bool is_wanted() const {
    return row_ - window_.row < window_.rows && column_ - window_.column < window_.columns;
  }
  void step() {
    if (++column_ < whole_.grid.columns) return;
    column_ = 0;
    ++row_;
  }

  void store(double value) {
    const bool none = nodata_.has(value) || std::isnan(value);
    if (!none && std::abs(value) > largest_height) refuse_height(stream_.where(), column_, row_);
    check_memory(grid_, std::span<const double>(&value, none ? 0 : 1));
    grid_.heights.push_back(none ? std::numeric_limits<double>::quiet_NaN() : value);
  }

  // Lines may hold parts of a row or whole rows, but no row may begin inside a line that began
  // inside another: there a value is missing or too much.
  void end_line() {
    const std::uint64_t columns = whole_.grid.columns;
    if (on_line_ != 0) {
      const std::uint64_t before = (count_ - on_line_) % columns;
      const bool whole_rows = before == 0 && on_line_ % columns == 0;
      if (on_line_ != columns && odd_line_ == 0) {
        odd_line_ = line_;
        on_odd_line_ = on_line_;
      }
      if (!whole_rows && before + on_line_ > columns) shifted_ = true;
    }
    on_line_ = 0;
    line_ = stream_.line();
  }

  void check_count() const {
    const std::uint64_t wanted = whole_.grid.size();
    if (count_ == wanted && !shifted_) return;
    std::string problem = "holds " + std::to_string(count_) + " values, but its header says " +
                          std::to_string(wanted) + " (" + std::to_string(whole_.grid.columns) +
                          " columns, " + std::to_string(whole_.grid.rows) + " rows)";
    if (odd_line_ != 0) {
      problem += "; line " + std::to_string(odd_line_) +
                 (on_odd_line_ < whole_.grid.columns ? " is short, with " : " has ") +
                 std::to_string(on_odd_line_) + " values";
    }
    throw InputError(grid_.source, std::move(problem),
                     count_ < wanted ? "add what is missing, or export the file again"
                                     : "correct the header, or remove what is too much");
  }

  NumberStream stream_;
  const TextRaster& whole_;
  const GridWindow window_;
  HeightGrid& grid_;
  const NodataRange nodata_;
  const bool room_;
  std::uint32_t column_ = 0;  // of the next word
  std::uint32_t row_;
  std::uint64_t count_ = 0, on_line_ = 0;
  std::int64_t line_ = 1;
  std::int64_t odd_line_ = 0;  // the first with another number of values than columns
  std::uint64_t on_odd_line_ = 0;
  bool shifted_ = false;
};

}  // namespace

void read_text_heights(const InputFile& file, const TextRaster& whole, const GridWindow& window,
                       HeightGrid& grid, TextRows& rows) {
  if (rows.begins.empty()) {
    const TextPlace begin{whole.offset, whole.line};
    rows = TextHeights(file, whole, window, grid, begin, 0).read_and_check();
  } else {
    const std::uint32_t k = window.row / rows.step;
    TextHeights(file, whole, window, grid, rows.begins[k], k * rows.step).read();
  }
}

}  // namespace lepp
