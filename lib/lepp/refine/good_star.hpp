#pragma once

#include <cstdint>
#include <vector>

#include "lepp/refine/angle_test.hpp"
#include "lepp/refine/feasible_place.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/cavity.hpp"
#include "lepp/triangulation/relocate.hpp"

namespace lepp {

/// Puts vertices where every triangle around them is good: no angle below the bound, no constrained
/// edge encroached. The flips that follow only raise the smallest angle.
class GoodStar {
 public:
  GoodStar(Mesh& mesh, const RefineOptions& options, double floor);

  /// Moves corner `corner` of `t`, an interior Steiner point, if there is a good place for it in
  /// its star and it has not been moved too often. \return whether it was moved
  bool move_corner(TriangleId t, std::uint32_t corner, std::vector<TriangleId>& changed);

  /// Inserts a vertex where the star that replaces `cavity` is good, if there is such a place.
  /// \pre cavity.find() returned true for `p`, nothing changed since
  bool insert(Cavity& cavity, Point p, std::vector<TriangleId>& changed);

 private:
  bool is_good(Point p) const;
  bool encroaches_beyond_link(Point p);

  Mesh& mesh_;
  double floor_;
  bool encroaching_allowed_;
  AngleTest angle_;
  FeasiblePlace place_;
  Star star_;
  std::vector<HalfEdge> stack_;
  std::vector<std::uint8_t> moves_;  // by vertex
};

}  // namespace lepp
