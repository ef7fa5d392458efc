// SPDX-License-Identifier: GPL-2.0-or-later
#include "read_mesh.hpp"

#include <gmsh.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>

#include "read_geometry.hpp"

namespace lepp::gmsh_helper {
namespace {

constexpr int line_type = 1, triangle_type = 2, point_type = 15;

std::vector<int> united(std::vector<int> a, const std::vector<int>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  a.erase(std::unique(a.begin(), a.end()), a.end());
  return a;
}

/// The elements of one type on one entity.
struct Block {
  std::vector<std::size_t> tags, nodes;
};

class MeshReader {
 public:
  explicit MeshReader(GmshRecord& record) : record_(record), mesh_(record.mesh.emplace()) {}

  void run() {
    refuse_other_elements();
    read_nodes();
    gmsh::vectorpair entities;
    gmsh::model::getEntities(entities);
    for (const auto& [dimension, tag] : entities)
      if (dimension <= 2) read_entity(dimension, tag);
    for (const auto& [entity, groups] : groups_) add_entity(entity.first, entity.second, groups);
  }

 private:
  using Entity = std::pair<int, int>;  // dimension and tag

  static void refuse_other_elements() {
    std::vector<int> types;
    gmsh::model::mesh::getElementTypes(types);
    for (const int type : types) {
      if (type == line_type || type == triangle_type || type == point_type) continue;
      std::string name;
      int dimension = 0, order = 0, nodes = 0, primary = 0;
      std::vector<double> local;
      gmsh::model::mesh::getElementProperties(type, name, dimension, order, nodes, local, primary);
      throw GmshFailure{ErrorKind::input, "", "it holds elements of type " + name,
                        "give a mesh of 3-node triangles"};
    }
  }

  void read_nodes() {
    std::vector<std::size_t> tags;
    std::vector<double> parameters;
    gmsh::model::mesh::getNodes(tags, mesh_.coordinates, parameters, -1, -1, false, false);
    for (const std::size_t tag : tags) {
      index_.emplace(tag, static_cast<std::uint32_t>(mesh_.node_tags.size()));
      mesh_.node_tags.push_back(static_cast<std::int64_t>(tag));
    }
  }

  /// The entity that a part belongs to; nothing for what only partitioning made. Ghost elements,
  /// which repeat the neighbouring part, stay an entity of their own.
  static std::optional<Entity> whole(int dimension, int tag) {
    std::string type;
    gmsh::model::getType(dimension, tag, type);
    if (!type.starts_with("Partition")) return Entity{dimension, tag};
    int parent_dimension = -1, parent = -1;
    gmsh::model::getParent(dimension, tag, parent_dimension, parent);
    if (parent_dimension != dimension || parent < 0) return std::nullopt;
    return Entity{dimension, parent};
  }

  void read_entity(int dimension, int tag) {
    const auto entity = whole(dimension, tag);
    if (!entity) return;
    const int type = dimension == 0 ? point_type : dimension == 1 ? line_type : triangle_type;
    Block block;
    gmsh::model::mesh::getElementsByType(type, block.tags, block.nodes, tag);
    if (block.tags.empty()) return;
    auto& groups = groups_[*entity];
    groups =
        united(united(groups, groups_of(dimension, tag)), groups_of(entity->first, entity->second));
    if (dimension == 0) take_points(block, entity->second);
    if (dimension == 1) take_lines(block, entity->second);
    if (dimension == 2) take_triangles(block, entity->second);
  }

  std::uint32_t node(std::size_t tag) const {
    const auto found = index_.find(tag);
    if (found != index_.end()) return found->second;
    throw GmshFailure{ErrorKind::input, "node " + std::to_string(tag),
                      "an element refers to it, but the file does not define it",
                      "write the mesh again with all its nodes"};
  }

  void take_points(const Block& block, int point) {
    for (std::size_t i = 0; i < block.tags.size(); ++i)
      mesh_.points.push_back(
          {static_cast<std::int64_t>(block.tags[i]), node(block.nodes[i]), point});
  }

  void take_lines(const Block& block, int curve) {
    for (std::size_t i = 0; i < block.tags.size(); ++i)
      mesh_.lines.push_back({static_cast<std::int64_t>(block.tags[i]),
                             {node(block.nodes[2 * i]), node(block.nodes[2 * i + 1])},
                             curve});
  }

  void take_triangles(const Block& block, int surface) {
    for (std::size_t i = 0; i < block.tags.size(); ++i) {
      const std::size_t* corners = &block.nodes[3 * i];
      mesh_.triangles.push_back({static_cast<std::int64_t>(block.tags[i]),
                                 {node(corners[0]), node(corners[1]), node(corners[2])},
                                 surface});
    }
  }

  void add_entity(int dimension, int tag, const std::vector<int>& groups) {
    if (dimension == 0) record_.points.push_back({tag, {}, 0, groups});
    if (dimension == 1) {
      GmshCurve& curve = record_.curves.emplace_back();
      curve.tag = tag;
      curve.groups = groups;
    }
    if (dimension == 2) {
      GmshSurface& surface = record_.surfaces.emplace_back();
      surface.tag = tag;
      surface.groups = groups;
    }
  }

  GmshRecord& record_;
  GmshMesh& mesh_;
  std::unordered_map<std::size_t, std::uint32_t> index_;
  std::map<Entity, std::vector<int>> groups_;
};

}  // namespace

void add_mesh(GmshRecord& record) { MeshReader(record).run(); }

}  // namespace lepp::gmsh_helper
