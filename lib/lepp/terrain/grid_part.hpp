#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lepp/terrain/height_grid.hpp"

namespace lepp {

/// A part of a larger grid, such as a tile that shares its outermost samples with its neighbours,
/// and which samples one step beyond have data. With that, each part knows by itself what the
/// outlines of its neighbours do on their common border.
struct GridPart {
  HeightGrid grid;
  /// By column, from the one west of the part to the one east of it; empty: the grid ends there.
  std::vector<bool> south, north;
  /// By line, the southern one first; empty: the grid ends there.
  std::vector<bool> west, east;

  /// \pre  both at most one step outside of the part
  bool has_data(std::int64_t column, std::int64_t line) const;
  /// True if three or four samples of a cell have data; its samples are as above.
  bool is_covered(std::int64_t column, std::int64_t line) const;
};

enum class GridSide { south, east, north, west };

/// \param around  the whole grid, or the part with one more row and column where the whole goes on
/// \param part    where the part lies in `around`
GridPart part_of(const HeightGrid& around, const GridWindow& part);

/// Samples of the border that no cell of the part covers lose their data here if a cell of a
/// neighbour covers them, or else to the neighbour in the north or east: a sample that stands alone
/// on a border gets its square (terrain_domain.hpp) from one part only. So each sample with data is
/// in the domain of some part, and domains do not overlap.
/// \return  how many they are
std::size_t leave_to_neighbours(GridPart& part);

/// The samples of a side, by column or line, where the outline of the part or of its neighbour
/// comes to the side that it then follows, or turns away from it, and both ends of the side;
/// ascending. Between two of them both outlines follow the side, or one of them, or none. The
/// neighbour finds the same ones.
std::vector<std::uint32_t> border_corners(const GridPart& part, GridSide side);

}  // namespace lepp
