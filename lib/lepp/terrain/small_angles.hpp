#pragma once

#include <array>
#include <set>
#include <span>
#include <vector>

#include "lepp/triangulation/mesh.hpp"
#include "lepp/triangulation/unfinished.hpp"

namespace lepp {

/// False where constrained edges force the angles of `t`, or the input is too fine there for a size
/// floor of `floor`.
bool is_improvable(const Mesh& mesh, TriangleId t, double floor);

/// Triangles that were given up because a side of the domain has to stay whole, known by their
/// corners: one that changes is none of them any more.
class AtKeptBorder {
 public:
  void add(const Mesh& mesh, TriangleId t) { corners_.insert(mesh.vertices(t)); }
  bool contains(const Mesh& mesh, TriangleId t) const {
    return corners_.contains(mesh.vertices(t));
  }
  void clear() { corners_.clear(); }

 private:
  std::set<std::array<VertexId, 3>> corners_;
};

/// What made a loop leave triangles below its bound that neither the input nor a border excuses.
struct LoopEnd {
  bool cancelled = false;
  bool used_up = false;  ///< the vertices that there may be
};

/// The triangles of a TIN with an angle below `min_angle_deg`, and why. Cost O(triangles)
std::vector<Unfinished> small_angles(const Mesh& mesh, double min_angle_deg, const LoopEnd& end,
                                     const AtKeptBorder& at_kept_border);

/// True of what no method could mend: for the input's sake, or a border's that has to stay whole.
bool is_excused(Reason reason);
/// True if nothing but the input, or borders that have to stay whole, kept triangles below a bound.
bool are_excused(std::span<const Unfinished> unfinished);

}  // namespace lepp
