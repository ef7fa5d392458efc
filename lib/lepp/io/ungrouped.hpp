#pragma once

#include <set>
#include <vector>

#include "lepp/geometry/entities.hpp"

namespace lepp {

/// The group for what is in no group of its dimension, with the smallest tag that is free there.
/// Formats and programs that know groups tend to lose what has none.
inline PhysicalGroup ungrouped(const std::vector<PhysicalGroup>& groups, int dimension) {
  std::set<int> taken;
  for (const PhysicalGroup& g : groups) {
    if (g.dimension == dimension) taken.insert(g.tag);
  }
  int tag = 1;
  while (taken.contains(tag)) ++tag;
  return {dimension, tag, "ungrouped"};
}

}  // namespace lepp
