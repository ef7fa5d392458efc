#pragma once

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Off-centres for one angle bound [ungor2009].
///
///           o          The triangle joins the shortest edge pq of the target to its circumcentre
///          / \         c; seen from there, pq spans an angle below the bound if the target is far
///        r--c          worse than it. The off-centre o is then taken nearer, where pq spans the
///       / \ |\         bound (a little more, so that rounding does no harm): a shorter way to
///      p---q           the same new triangle with fewer points to follow.
class OffCentre {
 public:
  explicit OffCentre(double min_angle_deg);

  /// \pre a, b, c counter-clockwise
  Point operator()(Point a, Point b, Point c) const;

 private:
  double height_;  // of the new triangle on a base of length 1
};

}  // namespace lepp
