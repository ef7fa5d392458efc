#pragma once

#include <functional>

#include "lepp/refine/size_test.hpp"
#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Where points go that make triangles smaller: on a front of triangles of the wanted size, which
/// grows from the constrained edges inwards.
///
///           o          The base pq of a triangle that is too large has about the wanted length: it
///          / \         belongs to a triangle of the front, or to the boundary. The new point o
///         /   \        makes a triangle with two sides of the wanted length h on that base, unless
///        p-----q       the circumcentre is nearer (then the gap is filled), or the angle bound
///       front          wants the off-centre, which is nearer still where pq is short.
class SizePoint {
 public:
  SizePoint(const Mesh& mesh, const SizeTest& size) : mesh_(mesh), size_(size) {}

  /// Is the shortest edge of `t` about as long as the edges that are wanted there?
  bool is_on_front(TriangleId t) const;

  /// The point for `t`. \pre `t` is too large; `off_centre` is its off-centre
  Point operator()(TriangleId t, Point off_centre) const;

 private:
  const Mesh& mesh_;
  const SizeTest& size_;
};

/// Cuts every constrained edge that is longer than wanted into equal parts, on its curve if it has
/// one, as long as `may_go_on` returns true. Where edges meet sharply, refinement cuts them later.
void cut_evenly(Mesh& mesh, const SizeTest& size, double floor,
                const std::function<bool()>& may_go_on);

}  // namespace lepp
