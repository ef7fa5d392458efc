#pragma once

#include <optional>
#include <vector>

#include "lepp/triangulation/raw_triangulation.hpp"
#include "lepp/triangulation/segments.hpp"

namespace lepp {

/// The surface of each component where curves say which surfaces they bound: crossing an edge of
/// such a curve enters or leaves each of them. From the outside, where no surface is, the sets of
/// surfaces are carried across every edge.
/// \param count  labels on the triangles run from 1 to count
/// \return by label, from 1 on; nothing: in no surface
/// \throw  InputError  two surfaces overlap, a boundary is not closed or encloses nothing
/// Cost    O(triangles + (pieces + sets toggled) log pieces)
std::vector<std::optional<SurfaceId>> regions_by_bounds(const RawTriangulation& raw,
                                                        const Pslg& pslg,
                                                        const SegmentPieces& pieces,
                                                        std::uint32_t count);

}  // namespace lepp
