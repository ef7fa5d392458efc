#include "lepp/io/gmsh_mesh_entities.hpp"

#include <algorithm>

namespace lepp {

std::vector<int> GmshMeshEntities::groups_of(const std::vector<std::int64_t>& elements) const {
  std::vector<int> groups;
  for (const std::int64_t element : elements) {
    const auto found = old_groups_.find(element);
    if (found != old_groups_.end() && found->second != 0) groups.push_back(std::abs(found->second));
  }
  std::sort(groups.begin(), groups.end());
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  return groups;
}

std::size_t GmshMeshEntities::index(int tag, const std::vector<int>& groups) {
  const auto [found, is_new] = index_.try_emplace({tag, groups}, entities_.size());
  if (is_new) {
    if (old_groups_.empty()) entities_.push_back({tag, known_[tag]});
    else entities_.push_back({free_tag(tag, groups), groups});
  }
  return found->second;
}

/// The entity's own tag if it is a tag and nobody has it; else that of its group; else a new one.
int GmshMeshEntities::free_tag(int tag, const std::vector<int>& groups) {
  std::vector<int> wanted = {tag};
  wanted.insert(wanted.end(), groups.begin(), groups.end());
  for (const int candidate : wanted)
    if (candidate > 0 && taken_.insert(candidate).second) return candidate;
  int candidate = 1;
  while (!taken_.insert(candidate).second) ++candidate;
  return candidate;
}

}  // namespace lepp
