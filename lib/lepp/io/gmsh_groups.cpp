#include "lepp/io/gmsh_groups.hpp"

#include <array>

namespace lepp {

GmshGroups::GmshGroups(const GmshRecord& record) {
  for (const GmshGroup& group : record.groups)
    known_[{group.dimension, group.tag}].name = group.name;
}

std::vector<GroupId> GmshGroups::ids(int dimension, const std::vector<int>& tags) {
  std::vector<GroupId> result;
  for (const int tag : tags) {
    Known& group = known_[{dimension, tag}];
    if (!group.used) {
      group.used = true;
      group.id = GroupId(used_.size());
      used_.push_back({dimension, tag, group.name});
    }
    result.push_back(group.id);
  }
  return result;
}

void GmshGroups::finish(Entities& entities) {
  std::vector<GroupId> renumbered(used_.size());
  for (const auto& [key, group] : known_) {
    if (!group.used) continue;
    renumbered[group.id.index()] = GroupId(entities.groups.size());
    entities.groups.push_back(used_[group.id.index()]);
  }
  const auto renumber = [&](auto& items) {
    for (auto& item : items)
      for (GroupId& id : item.groups) id = renumbered[id.index()];
  };
  renumber(entities.points);
  renumber(entities.curves);
  renumber(entities.surfaces);
}

std::vector<std::string> GmshGroups::warnings() const {
  static constexpr std::array<const char*, 3> kinds = {"point", "curve", "surface"};
  std::vector<std::string> result;
  for (const auto& [key, group] : known_) {
    const auto [dimension, tag] = key;
    if (group.used || dimension < 0 || dimension > 2) continue;
    result.push_back(std::string("physical ") + kinds[static_cast<std::size_t>(dimension)] + " " +
                     std::to_string(tag) + (group.name.empty() ? "" : " \"" + group.name + "\"") +
                     " has no member in the mesh and is dropped");
  }
  return result;
}

}  // namespace lepp
