#pragma once

#include <cstddef>

#include "lepp/geometry/pslg.hpp"

namespace lepp::test {

/// CGAL on the same input, from points and segments in memory. Both return what is left, so that
/// nothing can be optimised away.
/// The Delaunay triangulation of the points: number of triangles.
std::size_t cgal_delaunay(const Pslg& pslg);
/// The constrained one, with what is outside the segments and in holes marked as such: number of
/// triangles inside.
std::size_t cgal_constrained_delaunay(const Pslg& pslg);

}  // namespace lepp::test
