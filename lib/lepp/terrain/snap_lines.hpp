#pragma once

#include <cstddef>

#include "lepp/terrain/line_graph.hpp"

namespace lepp {

/// Lines nearer to each other, to the outline or to a sample than this part of the shorter side of
/// a cell are meant to meet there: samples say nothing of what lies between, and a mesh with good
/// angles would have to become as fine.
inline constexpr double meeting_distance = 0.01;

/// Makes lines meet where they come within meeting_distance of a sample with data, of the outline,
/// or of each other, and cuts them wherever they meet. The outline stays where it is; points and
/// pieces of lines move by about that distance at most, and keep the heights of their place.
/// \return  in how many places lines were moved
/// Cost     O(cells that lines pass) and that of split_crossings(), a few times
std::size_t snap_lines(const HeightGrid& grid, LineGraph& graph);

}  // namespace lepp
