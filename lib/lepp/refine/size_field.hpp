#pragma once

#include <memory>
#include <vector>

#include "lepp/geometry/point.hpp"
#include "lepp/geometry/pslg.hpp"

namespace lepp {

/// A size wanted at one point: no edge near it is to be longer.
struct SizeSource {
  Point at;
  double size;  ///< a length, > 0
  /// Whether no edge of the triangle around the point is to be longer either, at any grading.
  bool holds_around_it = false;
};

/// The longest edge wanted at each point of the plane, from sizes wanted at some points:
/// the least of size_i + grading * |p - at_i|. So it changes by at most `grading` per unit of
/// length, whatever the sources are: a source that asks for too sudden a change has no effect.
/// Copies share the sources. To be given as RefineOptions::size.
class SizeField {
 public:
  /// \throw InputError  a size that is not above 0 or a place that is not finite; grading < 0
  SizeField(std::vector<SizeSource> sources, double grading);

  /// The least size of the sources that hold around them and lie in the counter-clockwise triangle
  /// abc or on its edges, if it is below `bound`; else `bound`. Cost O(log n + such sources near
  /// it)
  double least_within(Point a, Point b, Point c, double bound) const;

  /// Infinite without sources. Cost O(log n) where sizes vary little between near sources.
  double operator()(Point p) const;

 private:
  // Sources in a balanced tree: the middle of a range is its root, the halves are its subtrees.
  // Each node knows the box around its range and the least size in it.
  struct Node {
    SizeSource source;
    Point low, high;
    double least, least_around;  // of all, and of those that hold around them
  };
  static void build(std::vector<Node>& nodes);
  double lower_bound(const Node& node, Point p) const;

  std::shared_ptr<const std::vector<Node>> nodes_;
  double grading_;
};

/// The lengths of the segments as sizes, at their middles, a quarter larger: meshes then pass from
/// a boundary that is cut finely to a coarse inside without a jump, and leave the boundary as it is
/// where the lengths of neighbours differ little.
std::vector<SizeSource> sizes_of_segments(const Pslg& pslg);

}  // namespace lepp
