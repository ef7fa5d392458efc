#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "lepp/triangulation/raw_triangulation.hpp"

namespace lepp {

/// Two parts of a point array that a vertical or horizontal line separates.
struct Halves {
  std::size_t first_of_second = 0;
  bool by_y = false;  ///< the first part lies below the second, else left of it
};

/// The most even of the places where `points` can be cut so that every coordinate x (or y) before
/// the cut is smaller than every one behind it. Along a Hilbert curve there is one near the middle
/// unless the points are very uneven: a dense cluster in the corner of a wide frame has none.
/// \return nothing if the smaller part would have less than an eighth of the points.  Cost O(n)
std::optional<Halves> find_halves(std::span<const Point> points);

enum class Half { first, second };

/// Of the ghosts of one triangulated half, whose triangles lie from `first_triangle` on, the one
/// whose hull edge starts at the vertex farthest towards the other half.
/// Cost   O(triangles of the half up to the first ghost, ghosts); the halves can ask at once
std::uint32_t facing_ghost(const RawTriangulation& raw, std::uint32_t first_triangle,
                           const Halves& halves, Half half);

/// Joins the Delaunay triangulations of the two halves, each with its ghosts, into that of all
/// points: upwards from the common tangent below, as [guibas1985] do.
/// \pre    neither half lies on one line
/// \param facing  the facing_ghost() of either half
/// \param free    triangles that are not in use; further ones of the halves are freed and used
/// again Cost   O(triangles along the seam); of cocircular points the halves keep their edges
void merge_halves(RawTriangulation& raw, std::array<std::uint32_t, 2> facing,
                  std::array<std::uint32_t, 2> free);

}  // namespace lepp
