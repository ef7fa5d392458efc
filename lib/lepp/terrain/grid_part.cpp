#include "lepp/terrain/grid_part.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace lepp {

namespace {

// The window of rows and columns of `part`, widened by one step where there is more.
struct Halo {
  std::int64_t columns, rows;  // of all
  const HeightGrid& around;
  const GridWindow& part;

  bool has_data(std::int64_t column, std::int64_t row) const {
    return column >= 0 && column < columns && row >= 0 && row < rows &&
           around.has_data(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
  }
  // A row of the file just outside of the part.
  std::vector<bool> along_row(std::int64_t row) const {
    std::vector<bool> found;
    if (row < 0 || row >= rows) return found;
    for (std::int64_t c = -1; c <= part.columns; ++c)
      found.push_back(has_data(part.column + c, row));
    return found;
  }
  std::vector<bool> along_column(std::int64_t column, const HeightGrid& grid) const {
    std::vector<bool> found;
    if (column < 0 || column >= columns) return found;
    for (std::uint32_t line = 0; line < grid.rows; ++line)
      found.push_back(has_data(column, std::int64_t{part.row} + grid.row_of_line(line)));
    return found;
  }
};

bool flag(const std::vector<bool>& flags, std::int64_t i) {
  return !flags.empty() && flags[static_cast<std::size_t>(i)];
}

}  // namespace

bool GridPart::has_data(std::int64_t column, std::int64_t line) const {
  if (line < 0) return flag(south, column + 1);
  if (line >= grid.rows) return flag(north, column + 1);
  if (column < 0) return flag(west, line);
  if (column >= grid.columns) return flag(east, line);
  return grid.has_data(static_cast<std::uint32_t>(column),
                       grid.row_of_line(static_cast<std::uint32_t>(line)));
}

bool GridPart::is_covered(std::int64_t column, std::int64_t line) const {
  int count = 0;
  for (const std::int64_t north_of : {0, 1}) {
    for (const std::int64_t east_of : {0, 1})
      count += has_data(column + east_of, line + north_of) ? 1 : 0;
  }
  return count >= 3;
}

GridPart part_of(const HeightGrid& around, const GridWindow& window) {
  GridPart part;
  HeightGrid& grid = part.grid;
  grid.columns = window.columns;
  grid.rows = window.rows;
  grid.heights.reserve(grid.size());
  for (std::uint32_t row = 0; row < window.rows; ++row) {
    const std::size_t first = around.index(window.column, window.row + row);
    around.heights.visit(
        [&](auto all) { grid.heights.append(all.subspan(first, window.columns)); });
  }
  grid.origin = {around.origin.x + window.column * around.step_x,
                 around.origin.y + window.row * around.step_y};
  grid.step_x = around.step_x;
  grid.step_y = around.step_y;
  grid.georeferenced = around.georeferenced;
  grid.degrees = around.degrees;
  grid.crs = around.crs;
  grid.cell_width = around.cell_width;
  grid.cell_height = around.cell_height;
  grid.source = around.source;

  const Halo halo{around.columns, around.rows, around, window};
  const std::int64_t above = std::int64_t{window.row} - 1;
  const std::int64_t below = std::int64_t{window.row} + window.rows;
  part.south = halo.along_row(grid.north_first() ? below : above);
  part.north = halo.along_row(grid.north_first() ? above : below);
  part.west = halo.along_column(std::int64_t{window.column} - 1, grid);
  part.east = halo.along_column(std::int64_t{window.column} + window.columns, grid);
  return part;
}

std::size_t leave_to_neighbours(GridPart& part) {
  HeightGrid& grid = part.grid;
  const std::int64_t east = std::int64_t{grid.columns} - 1, north = std::int64_t{grid.rows} - 1;
  std::vector<std::size_t> left;
  const auto look = [&](std::int64_t column, std::int64_t line) {
    if (!part.has_data(column, line)) return;
    bool inside = false, beyond = false;
    for (const std::int64_t c : {column - 1, column}) {
      for (const std::int64_t l : {line - 1, line}) {
        if (!part.is_covered(c, l)) continue;
        const bool own = c >= 0 && c < east && l >= 0 && l < north;
        (own ? inside : beyond) = true;
      }
    }
    const bool of_neighbour =
        (column == east && !part.east.empty()) || (line == north && !part.north.empty());
    if (inside || !(beyond || of_neighbour)) return;
    left.push_back(grid.index(static_cast<std::uint32_t>(column),
                              grid.row_of_line(static_cast<std::uint32_t>(line))));
  };
  for (std::int64_t column = 0; column <= east; ++column) {
    look(column, 0);
    look(column, north);
  }
  for (std::int64_t line = 0; line <= north; ++line) {
    look(0, line);
    look(east, line);
  }
  // Only now: what is covered does not depend on the order.
  std::ranges::sort(left);  // corners were looked at twice
  left.erase(std::unique(left.begin(), left.end()), left.end());
  for (const std::size_t i : left) grid.heights.set(i, std::numeric_limits<double>::quiet_NaN());
  return left.size();
}

namespace {

// A side as a line of samples, with what lies beside it, inside and beyond.
class SideView {
 public:
  SideView(const GridPart& part, GridSide side)
      : part_(part),
        vertical_(side == GridSide::west || side == GridSide::east),
        count_(vertical_ ? part.grid.rows : part.grid.columns) {
    if (side == GridSide::east) at_ = std::int64_t{part.grid.columns} - 1;
    if (side == GridSide::north) at_ = std::int64_t{part.grid.rows} - 1;
  }

  std::int64_t count() const { return count_; }

  // What covers the piece from sample i to the next, on either hand.
  std::array<bool, 2> covers(std::int64_t i) const {
    if (!has_data(i, 0) || !has_data(i + 1, 0)) return {false, false};
    return {cell(i, -1), cell(i, 0)};
  }
  // The outline leaves the side at sample i though the pieces before and behind are alike.
  bool opens(std::int64_t i) const {
    const auto [before, behind] = covers(i);
    return (before && !has_data(i, -1)) || (behind && !has_data(i, 1));
  }

 private:
  bool has_data(std::int64_t i, std::int64_t beside) const {
    return vertical_ ? part_.has_data(at_ + beside, i) : part_.has_data(i, at_ + beside);
  }
  bool cell(std::int64_t i, std::int64_t beside) const {
    return vertical_ ? part_.is_covered(at_ + beside, i) : part_.is_covered(i, at_ + beside);
  }

  const GridPart& part_;
  const bool vertical_;
  const std::int64_t count_;
  std::int64_t at_ = 0;  // column or line of the side
};

}  // namespace

std::vector<std::uint32_t> border_corners(const GridPart& part, GridSide side) {
  const SideView view(part, side);
  std::vector<std::uint32_t> corners;
  for (std::int64_t i = 0; i < view.count(); ++i) {
    const bool end = i == 0 || i + 1 == view.count();
    if (end || view.covers(i - 1) != view.covers(i) || view.opens(i))
      corners.push_back(static_cast<std::uint32_t>(i));
  }
  return corners;
}

}  // namespace lepp
