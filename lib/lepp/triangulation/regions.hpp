#pragma once

#include <optional>
#include <vector>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/raw_triangulation.hpp"
#include "lepp/triangulation/segments.hpp"

namespace lepp {

/// Which surface each part of the plane belongs to.
struct Regions {
  /// By label, from 1 on; nothing: no mesh there. Labels are on the triangles of `raw`.
  std::vector<std::optional<SurfaceId>> of_label;
  Entities entities;  ///< of the PSLG, with a default surface where one was needed
};

/// Labels the connected components of the triangles of `raw` across unconstrained edges, and finds
/// the surface of each as Pslg says: by the boundaries of surfaces, or by holes and seeds.
/// \throw  InputError  surfaces overlap or are not closed, a hole reaches the outside, a hole or
///         seed lies on a segment
/// Cost    O(triangles); seeds are found from each other along the spatial order.
Regions find_regions(RawTriangulation& raw, const Pslg& pslg, const SegmentPieces& pieces,
                     TriangulationReport& report, unsigned threads);

}  // namespace lepp
