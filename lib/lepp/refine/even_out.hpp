#pragma once

#include <cstddef>
#include <vector>

#include "lepp/refine/good_star.hpp"
#include "lepp/refine/refine.hpp"

namespace lepp {

/// Where sizes rule, triangles are near-equilateral but for seams where fronts met. This moves the
/// interior Steiner points of obtuse triangles, and their neighbours, towards the mean of their
/// neighbours wherever the largest angle around them becomes smaller and every bound still holds.
/// The mesh stays constrained Delaunay.
class EvenOut {
 public:
  EvenOut(Mesh& mesh, const RefineOptions& options, double floor);

  void run();

 private:
  std::size_t round();
  bool move_towards_mean(TriangleId t, std::uint32_t corner);
  bool is_obtuse_at(TriangleId t) const;

  Mesh& mesh_;
  const RefineOptions& options_;
  GoodStar good_star_;
  Star star_;
  std::vector<TriangleId> changed_;
};

}  // namespace lepp
