#pragma once

#include <optional>
#include <string>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/oracle_arrangement.hpp"

namespace lepp::test {

/// What became of one PSLG.
struct Trial {
  std::optional<std::string> failure;   ///< what the library got wrong, if anything
  std::optional<Triangulation> result;  ///< the mesh, unless the input was refused
  bool refused_split = false;  ///< crossings were split, then holes, seeds or no area refused
};

/// Triangulates and checks every invariant. An InputError is right only where the oracle sees a
/// reason: crossing segments that were not to be split, no area, a hole or seed on a segment, holes
/// that may remove everything. Crossing segments without an InputError are a failure too, and so
/// are crossings that could not be split.
/// \pre each segment has a curve of its own
Trial try_pslg(const Pslg& pslg, const Arrangement& arrangement, Crossings crossings);

/// What the mesh of the library and that of the plain kernel differ in, or nothing. The edges must
/// be the same if no four points of the mesh's neighbours are cocircular, else their number.
/// \pre `result` is the mesh of `pslg`, which the plain kernel can do
std::optional<std::string> difference_from_plain(const Triangulation& result, const Pslg& pslg);

/// True if both have the same vertices, triangles, regions, constrained edges, in the same order.
bool are_same(const Mesh& a, const Mesh& b);

/// True if the constrained Delaunay triangulation is the only one: no inner edge without a segment
/// has four cocircular points around it.
bool is_unique(const Mesh& mesh);

}  // namespace lepp::test
