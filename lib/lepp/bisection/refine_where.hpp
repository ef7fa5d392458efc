#pragma once

#include <cstddef>
#include <functional>

#include "lepp/bisection/forest.hpp"

namespace lepp {

struct WhereOptions {
  BisectOptions bisect;  ///< its max_vertices holds for all rounds together
  /// Called between two rounds with the number of vertices; false stops.
  std::function<bool(std::size_t vertices)> progress;
};

struct RefineWhereReport {
  bool finished = false;  ///< no triangle is left that is to be cut
  std::size_t rounds = 0;
  Refinement done;  ///< of all rounds, one after the other; each refused triangle once
};

/// Cuts every triangle for which `is_to_be_cut` is true, and its parts again, until none is left:
/// the refinement region problem (Definition 2 of the paper) if it asks for triangles that meet a
/// region and are not small enough.
/// \pre   is_to_be_cut(mesh, t) depends on the corners of t alone, and is false for small triangles
/// \throw as Forest::bisect(), and what is_to_be_cut and progress throw; the mesh
///        then conforms, and is finer than it was
/// Cost   one call per triangle of the start and per new one, beside the cuts
RefineWhereReport refine_where(Forest& forest,
                               const std::function<bool(const Mesh&, TriangleId)>& is_to_be_cut,
                               const WhereOptions& options = {});

/// The longest edge of a triangle.
double diameter(const Mesh& mesh, TriangleId t);

}  // namespace lepp
