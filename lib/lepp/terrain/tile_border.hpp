#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lepp/terrain/grid_part.hpp"
#include "lepp/terrain/terrain_domain.hpp"

namespace lepp {

/// The samples of a line that become vertices where the line is the border of a tile. They follow
/// from the heights of the line alone, so that two tiles, or two grids cut apart, agree on them
/// whatever lies beside the line: between two neighbours the straight line is off by `max_error` at
/// most, pieces side by side differ in length by a factor of 2 at most, and at both ends of a run
/// of samples with data pieces are one sample long, so that lines that meet in the corner of a tile
/// match in length.
/// \param heights  NaN where there is no data
/// \param corners  ascending: more samples that end a run, where the outline on one side of the
///                 line leaves it (border_corners() in grid_part.hpp)
/// \return  ascending indices; both ends of each run of samples with data are among them
/// Cost     O(n log n)
std::vector<std::uint32_t> border_samples(std::span<const double> heights, double max_error,
                                          std::span<const std::uint32_t> corners = {});

/// border_corners() of the sides, by GridSide.
using BorderCorners = std::array<std::vector<std::uint32_t>, 4>;
BorderCorners border_corners(const GridPart& part);

/// Makes the four sides of the grid borders: the domain gets the vertices of border_samples() on
/// them, and sides between two of them are not cut (TerrainDomain::kept_border).
void fix_borders(const HeightGrid& grid, double max_error, TerrainDomain& domain,
                 const BorderCorners& corners = {});

/// Where borders that must not be cut may be to blame for a small angle: nearer to one than twice
/// the length of the pieces there. A vertex inside the circle around a piece would ask for a cut,
/// so triangles as far away may be without the one they need.
class NearBorder {
 public:
  /// \param domain  after fix_borders()
  NearBorder(const HeightGrid& grid, const TerrainDomain& domain);
  bool operator()(Point p) const;

 private:
  std::array<std::vector<double>, 4> ends_;  // of pieces: on the west, east, south, north side
  Point corner_;                             // the north-eastern one
};

}  // namespace lepp
