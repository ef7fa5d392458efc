#pragma once

#include <optional>
#include <vector>

#include "lepp/triangulation/constrained_delaunay.hpp"

namespace lepp::plain {

/// For each triangle of the triangulated convex hull, the surface it belongs to, or nothing where
/// there is no domain. May add a default surface to the mesh's entities, for areas without seed.
/// The three ways to find the domain are those of Pslg.
/// \pre    M1 to M3, every segment is a chain of constrained edges
/// \throw  InputError: a surface boundary that is not closed, surfaces that overlap or are empty,
///         a hole or seed on a segment, no domain left
std::vector<std::optional<SurfaceId>> find_regions(Mesh& mesh, const Pslg& pslg,
                                                   TriangulationReport& report);

/// The part of `mesh` whose triangles have a region, with every boundary edge constrained.
/// Vertices and segments keep their order; what lies outside is counted in `report`.
Mesh extract_regions(const Mesh& mesh, const std::vector<std::optional<SurfaceId>>& regions,
                     TriangulationReport& report);

}  // namespace lepp::plain
