#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "lepp/io/gmsh_mesh_file.hpp"
#include "lepp/io/gmsh_record.hpp"

namespace lepp {

/// The curves or the surfaces of a .msh file, numbered as elements first name them.
///
/// Format 4 gives groups to entities: there an entity is its tag. Formats 1 and 2 give a group to
/// each element, and repeat an element that has several: there an entity is its tag and the groups
/// of its elements, and if one tag stands for several such entities all but the first get another.
class GmshMeshEntities {
 public:
  struct Entity {
    int tag = 0;
    std::vector<int> groups;
  };

  /// \param known  tag and groups of the file's entities, used where `old_groups` is empty
  GmshMeshEntities(std::map<int, std::vector<int>> known, const ElementGroups& old_groups)
      : known_(std::move(known)), old_groups_(old_groups) {}

  /// The groups of the elements with these numbers: those on the same nodes.
  std::vector<int> groups_of(const std::vector<std::int64_t>& elements) const;
  /// Index of the entity with this tag and, in an old file, these groups.
  std::size_t index(int tag, const std::vector<int>& groups);

  const std::vector<Entity>& entities() const { return entities_; }

 private:
  int free_tag(int tag, const std::vector<int>& groups);

  std::map<int, std::vector<int>> known_;
  const ElementGroups& old_groups_;
  std::map<std::pair<int, std::vector<int>>, std::size_t> index_;
  std::set<int> taken_;
  std::vector<Entity> entities_;
};

}  // namespace lepp
