#pragma once

#include <optional>
#include <string>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/oracle_arrangement.hpp"

namespace lepp::test {

/// What must hold for every mesh; each function returns the first broken rule in words, or
/// nothing. Signs come from the oracle and neighbours from sorted edges, so nothing is shared with
/// the library but the reading accessors of Mesh. Cost O(n log n).

/// Ids in range, every vertex used, no two at one place; triangles strictly counter-clockwise, at
/// most one on each side of an edge, neighbours right; triangles turn once around each inner
/// vertex; Euler's formula with components and boundary cycles counted; the boundary and edges
/// between regions constrained, both sides agreeing.
std::optional<std::string> broken_topology(const Mesh& mesh);

/// Each unconstrained edge locally Delaunay: with the rules above, no visible vertex lies strictly
/// inside a circumcircle.
std::optional<std::string> broken_delaunay(const Mesh& mesh);

/// The mesh of a PSLG that does not cross itself holds the PSLG: vertices are its points, in
/// order; each piece is a constrained edge that its segment's curve owns, or lies outside; no other
/// edge is constrained but the sides of a hull; without closed faces the mesh is the convex hull,
/// else it has as many faces as the PSLG closes, less its holes; seeds give their regions.
/// \pre broken_topology() has nothing to say; every segment has a curve of its own
std::optional<std::string> broken_promise(const Mesh& mesh, const TriangulationReport& report,
                                          const Pslg& pslg, const Arrangement& arrangement);

/// The same for segments that were cut where they cross: their pieces lie within a few ulp of
/// them, and run from one end to the other where nothing is outside.
std::optional<std::string> broken_split_promise(const Mesh& mesh, const TriangulationReport& report,
                                                const Pslg& pslg);

/// All of the above that apply. `split` says which of the last two.
std::optional<std::string> broken_invariant(const Triangulation& result, const Pslg& pslg,
                                            const Arrangement& arrangement, Crossings crossings);

}  // namespace lepp::test
