#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lepp/geometry/point.hpp"

namespace lepp {

/// The indices of `points` along a Hilbert curve: points that follow each other lie close together.
/// Equal points stand side by side, the smaller index first. Cells of the curve that hold many
/// points are divided again by a curve of their own, so clusters of any scale stay in order.
/// The curve passes through one half of the longer side before the other one.
/// \pre   coordinates are finite, fewer than 2^32 points
/// Cost   O(n) for each level of clustering (radix sort), 16 bytes a point while it runs.
std::vector<std::uint32_t> spatial_order(std::span<const Point> points);

}  // namespace lepp
