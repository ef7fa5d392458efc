#pragma once

#include <map>
#include <utility>
#include <vector>

#include "lepp/geometry/entities.hpp"

namespace lepp {

/// Collects the entities of a file that knows only numbers: markers of segments and attributes of
/// regions. Equal numbers are one entity; a positive tag is a physical group too.
class EntityTable {
 public:
  /// The curve of a boundary marker. \pre  marker != 0
  CurveId curve(int marker);
  /// The surface of a regional attribute and an area limit (infinity for none).
  SurfaceId surface(double attribute, double max_area);
  /// Numbers the surfaces and hands everything out: a whole attribute is its surface's tag, the
  /// others get the smallest positive tags that are free.
  Entities finish();

 private:
  std::vector<GroupId> group(int dimension, int tag);

  Entities entities_;
  std::map<int, CurveId> curves_;
  std::pair<int, CurveId> last_curve_;  // neighbours in a file mostly have the same number
  std::map<std::pair<double, double>, SurfaceId> surfaces_;
  std::map<std::pair<int, int>, GroupId> groups_;
};

}  // namespace lepp
