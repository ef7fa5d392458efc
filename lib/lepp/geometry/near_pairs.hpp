#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "lepp/geometry/point.hpp"

namespace lepp {

/// A straight piece from a to b, or a point (a == b), and how far around it something counts as
/// near: `reach` to each side in x and in y, >= 0.
struct Strip {
  Point a, b;
  Point reach{0, 0};
};

/// Calls visit(i, j), i < j, for every pair of strips that may overlap: whenever two strips have a
/// point in common their pair is visited, often more than once, together with a few pairs that
/// only come close. Pairs of two points are left out. The order is fixed by the input.
///
/// \pre   coordinates in the supported range of pslg.hpp
/// \param visit  returns false to stop
/// Cost   O(n log n + visited pairs) for coast lines, combs, spirals, stacks of long parallel
///        pieces in any direction, fans, and rays around a circle; pieces that cross each other
///        all over cost a small multiple of their crossings. docs/algorithms/crossings.md says how.
void for_each_near_pair(std::span<const Strip> strips,
                        const std::function<bool(std::uint32_t, std::uint32_t)>& visit);

}  // namespace lepp
