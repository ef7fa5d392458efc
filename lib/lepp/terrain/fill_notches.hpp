#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "lepp/terrain/outline_edges.hpp"

namespace lepp {

/// In place of the edge that follows one that is no longer there.
inline constexpr std::uint32_t removed = std::numeric_limits<std::uint32_t>::max();

/// Takes corners out of the rings of an outline: those on a straight line, and those where the
/// triangle to both neighbours lies outside and has no sample in it nor on its third side. So the
/// covered area grows, by no sample, and its angles grow.
///
///        a----b          a            b is no corner any more: the triangle abc, which lies
///   in        | \         \           outside, holds no sample
///     ________|  c     in   \___c
///
/// Corners where rings touch stay. No other ring reaches into such a triangle: its edges could only
/// end at a sample there. Nor does an edge pass a cell that has an island as a corner: it would
/// have a sample with data on its side, another on its line or beside that, and three are covered.
/// \param next  as next_edges(); on return the edges from the remaining corners
void fill_notches(const std::vector<OutlineEdge>& edges, std::vector<std::uint32_t>& next);

}  // namespace lepp
