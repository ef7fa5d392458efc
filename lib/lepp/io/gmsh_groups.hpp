#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lepp/geometry/entities.hpp"
#include "lepp/io/gmsh_record.hpp"

namespace lepp {

/// Hands out the groups of kept entities, in the order in which they are first asked for, so that
/// only groups with a member come through.
class GmshGroups {
 public:
  explicit GmshGroups(const GmshRecord& record);

  std::vector<GroupId> ids(int dimension, const std::vector<int>& tags);
  /// The groups that were asked for, sorted as Gmsh lists them; ids in `entities` are renumbered.
  void finish(Entities& entities);
  /// One sentence for each group of points, curves or surfaces that nobody asked for.
  std::vector<std::string> warnings() const;

 private:
  struct Known {
    std::string name;
    bool used = false;
    GroupId id;
  };
  std::map<std::pair<int, int>, Known> known_;  // by dimension and tag
  std::vector<PhysicalGroup> used_;
};

}  // namespace lepp
