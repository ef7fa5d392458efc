#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "lepp/geometry/pslg.hpp"

namespace lepp::test {

/// What a PSLG says, worked out pair by pair with the oracle's signs: its distinct points, and its
/// segments cut at every point exactly on them. Nothing is shared with the library.
struct Arrangement {
  /// An edge between two distinct points with no point in between; the smaller index first.
  using Piece = std::pair<std::uint32_t, std::uint32_t>;

  std::vector<Point> points;            ///< distinct, in the order of their first copy
  std::vector<std::uint32_t> point_of;  ///< for each point of the PSLG, its index in `points`
  /// For each segment the points it passes through, from end to end; one if it has no length.
  std::vector<std::vector<std::uint32_t>> chains;
  std::vector<Piece> pieces;     ///< without repetitions, ascending
  std::vector<Piece> crossings;  ///< pairs of pieces (as indices) that cross between their ends
  bool collinear = true;         ///< no three points span an area

  bool has_piece(std::uint32_t a, std::uint32_t b) const;
  /// The points on the boundary of the convex hull, counter-clockwise, those inside its sides too.
  /// \pre not collinear
  std::vector<std::uint32_t> hull() const;
  /// Bounded faces of the planar graph of the pieces and `more` edges, by Euler's formula.
  /// \pre no crossings, and `more` has no piece
  std::size_t closed_faces(const std::vector<Piece>& more = {}) const;
};

/// \pre P1 and P2 of pslg.hpp. Cost: segments * points in x-ranges that overlap.
Arrangement arrange(const Pslg& pslg);

/// True if ab and cd cross at one point inside both.
bool cross_inside(Point a, Point b, Point c, Point d);

}  // namespace lepp::test
