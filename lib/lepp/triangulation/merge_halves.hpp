#pragma once

#include <cstddef>
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
/// unless the points are very uneven.
/// \return nothing if the smaller part would have less than an eighth of the points.  Cost O(n)
std::optional<Halves> find_halves(std::span<const Point> points);

/// Joins the Delaunay triangulations of the two halves, each with its ghosts, into that of all
/// points: upwards from the common tangent below, as [guibas1985] do.
/// \param free  a number of triangles that are not in use; two are needed, further ones of the
///              halves are freed and used again
/// Cost   O(triangles along the seam, ghosts); of cocircular points the halves keep their edges
void merge_halves(RawTriangulation& raw, const Halves& halves, std::span<const std::uint32_t> free);

}  // namespace lepp
