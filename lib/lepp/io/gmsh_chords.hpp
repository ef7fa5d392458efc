#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "lepp/io/gmsh_pieces.hpp"

namespace lepp {

/// Piece `piece` of polyline `polyline` (from point `piece` to the next).
struct ChordPlace {
  std::size_t polyline = 0, piece = 0;
};

/// Halves pieces of curves until none collides with anything else: the convex hull of a piece and
/// its curve meets no other hull and no isolated point, except at shared ends, where the two leave
/// in different directions. A vertex put on a curve later then stays on its side of everything.
/// \return  the pieces that still collide after 12 rounds: curves that cross, or touch in between
/// Cost     O(rounds * (n log n + pairs of pieces whose ranges of x overlap))
std::vector<ChordPlace> separate_chords(std::vector<Polyline>& polylines,
                                        std::span<const Point> isolated);

}  // namespace lepp
