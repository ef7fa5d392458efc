#include "lepp/io/msh.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "lepp/geometry/error.hpp"
#include "lepp/io/atomic_files.hpp"
#include "lepp/io/msh_entities.hpp"

namespace lepp {

namespace {

constexpr int line_element = 1, triangle_element = 2, point_element = 15;

std::size_t node(VertexId v) { return v.index() + 1; }

void check_groups(const Mesh& mesh, const std::string& file) {
  for (const PhysicalGroup& group : mesh.entities().groups) {
    const std::string where = file + ", physical group " + std::to_string(group.tag) +
                              " of dimension " + std::to_string(group.dimension);
    if (group.tag < 0) throw InputError(where, "its tag is negative", "give it another tag");
    if (group.name.find_first_of("\"\n\r") != std::string::npos) {
      throw InputError(where, "its name has a double quote or a line end",
                       "rename the group: a .msh file cannot hold that name");
    }
  }
}

void write_names(OutputFile& out, const std::vector<PhysicalGroup>& groups) {
  const auto named =
      std::ranges::count_if(groups, [](const PhysicalGroup& group) { return !group.name.empty(); });
  if (named == 0) return;
  out << "$PhysicalNames\n" << named << '\n';
  for (const PhysicalGroup& group : groups) {
    if (group.name.empty()) continue;
    out << group.dimension << ' ' << group.tag << " \"" << group.name << "\"\n";
  }
  out << "$EndPhysicalNames\n";
}

// Where vertices lie in space.
class Places {
 public:
  Places(const Mesh& mesh, std::span<const double> heights) : mesh_(mesh), heights_(heights) {}

  std::array<double, 3> operator[](VertexId v) const {
    const Point p = mesh_.point(v);
    return {p.x, p.y, heights_.empty() ? 0.0 : heights_[v.index()]};
  }

 private:
  const Mesh& mesh_;
  std::span<const double> heights_;
};

OutputFile& operator<<(OutputFile& out, const std::array<double, 3>& place) {
  return out << place[0] << ' ' << place[1] << ' ' << place[2];
}

class BoundingBox {
 public:
  void add(const std::array<double, 3>& place) {
    for (std::size_t i = 0; i < 3; ++i) {
      low_[i] = std::min(low_[i], place[i]);
      high_[i] = std::max(high_[i], place[i]);
    }
  }
  friend OutputFile& operator<<(OutputFile& out, const BoundingBox& box) {
    return out << box.low_ << ' ' << box.high_;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> low_{infinity, infinity, infinity}, high_{-infinity, -infinity, -infinity};
};

// ---- format 4.1 --------------------------------------------------------------------------------

void write_groups(OutputFile& out, const MshEntities& entities,
                  const std::vector<GroupId>& groups) {
  out << ' ' << groups.size();
  for (const GroupId g : groups) out << ' ' << entities.groups[g.index()].tag;
}

// The tag of the point that a curve ends at: every end of a curve is one.
int point_tag(const MshEntities& entities, VertexId v) {
  return entities.points[entities.owner_of_vertex[v.index()].index].tag;
}

void write_curve_entity(OutputFile& out, const Places& places, const MshEntities& entities,
                        const MshCurve& curve) {
  BoundingBox box;
  for (const auto& [a, b] : curve.lines) {
    box.add(places[a]);
    box.add(places[b]);
  }
  out << curve.tag << ' ' << box;
  write_groups(out, entities, curve.groups);
  out << ' ' << curve.ends.size();
  for (std::size_t i = 0; i < curve.ends.size(); ++i) {
    const int tag = point_tag(entities, curve.ends[i]);
    out << ' ' << (i == 0 ? tag : -tag);
  }
  out << '\n';
}

void write_surface_entity(OutputFile& out, const Mesh& mesh, const Places& places,
                          const MshEntities& entities, const MshSurface& surface) {
  BoundingBox box;
  for (const TriangleId t : surface.triangles) {
    for (const VertexId v : mesh.vertices(t)) box.add(places[v]);
  }
  out << surface.tag << ' ' << box;
  write_groups(out, entities, surface.groups);
  out << ' ' << surface.boundary.size();
  for (const int tag : surface.boundary) out << ' ' << tag;
  out << '\n';
}

void write_entities(OutputFile& out, const Mesh& mesh, const Places& places,
                    const MshEntities& entities) {
  out << "$Entities\n"
      << entities.points.size() << ' ' << entities.curves.size() << ' ' << entities.surfaces.size()
      << " 0\n";
  for (const MshPoint& p : entities.points) {
    out << p.tag << ' ' << places[p.vertex];
    write_groups(out, entities, p.groups);
    out << '\n';
  }
  for (const MshCurve& curve : entities.curves) write_curve_entity(out, places, entities, curve);
  for (const MshSurface& surface : entities.surfaces) {
    write_surface_entity(out, mesh, places, entities, surface);
  }
  out << "$EndEntities\n";
}

// The vertices that each entity owns, dimension by dimension.
using NodeLists = std::array<std::vector<std::vector<VertexId>>, 3>;

NodeLists node_lists(const MshEntities& entities) {
  NodeLists lists;
  lists[0].resize(entities.points.size());
  lists[1].resize(entities.curves.size());
  lists[2].resize(entities.surfaces.size());
  for (std::size_t i = 0; i < entities.owner_of_vertex.size(); ++i) {
    const auto [dimension, index] = entities.owner_of_vertex[i];
    lists[dimension][index].emplace_back(i);
  }
  return lists;
}

int entity_tag(const MshEntities& entities, std::size_t dimension, std::size_t index) {
  if (dimension == 0) return entities.points[index].tag;
  return dimension == 1 ? entities.curves[index].tag : entities.surfaces[index].tag;
}

void write_nodes_41(OutputFile& out, const Places& places, const MshEntities& entities) {
  const NodeLists lists = node_lists(entities);
  std::size_t blocks = 0;
  for (const auto& of_dimension : lists) {
    blocks += static_cast<std::size_t>(
        std::ranges::count_if(of_dimension, [](const auto& list) { return !list.empty(); }));
  }
  const std::size_t n = entities.owner_of_vertex.size();
  out << "$Nodes\n" << blocks << ' ' << n << " 1 " << n << '\n';
  for (std::size_t dimension = 0; dimension < 3; ++dimension) {
    for (std::size_t i = 0; i < lists[dimension].size(); ++i) {
      const auto& list = lists[dimension][i];
      if (list.empty()) continue;
      out << dimension << ' ' << entity_tag(entities, dimension, i) << " 0 " << list.size() << '\n';
      for (const VertexId v : list) out << node(v) << '\n';
      for (const VertexId v : list) out << places[v] << '\n';
    }
  }
  out << "$EndNodes\n";
}

void write_triangle_nodes(OutputFile& out, const Mesh& mesh, TriangleId t) {
  const auto& v = mesh.vertices(t);
  out << ' ' << node(v[0]) << ' ' << node(v[1]) << ' ' << node(v[2]) << '\n';
}

struct ElementCounts {
  std::size_t points = 0, lines = 0, triangles = 0;
  std::size_t all() const { return points + lines + triangles; }
};

ElementCounts count_elements(const Mesh& mesh, const MshEntities& entities) {
  ElementCounts counts;
  counts.points = static_cast<std::size_t>(
      std::ranges::count_if(entities.points, [](const MshPoint& p) { return p.is_written; }));
  for (const MshCurve& c : entities.curves) counts.lines += c.is_written ? c.lines.size() : 0;
  counts.triangles = mesh.triangle_count();
  return counts;
}

void write_elements_41(OutputFile& out, const Mesh& mesh, const MshEntities& entities) {
  const ElementCounts counts = count_elements(mesh, entities);
  const auto curves = static_cast<std::size_t>(
      std::ranges::count_if(entities.curves, [](const MshCurve& c) { return c.is_written; }));
  const std::size_t blocks = counts.points + curves + entities.surfaces.size();
  out << "$Elements\n" << blocks << ' ' << counts.all() << " 1 " << counts.all() << '\n';
  std::size_t tag = 0;
  for (const MshPoint& p : entities.points) {
    if (!p.is_written) continue;
    out << "0 " << p.tag << ' ' << point_element << " 1\n";
    out << ++tag << ' ' << node(p.vertex) << '\n';
  }
  for (const MshCurve& curve : entities.curves) {
    if (!curve.is_written) continue;
    out << "1 " << curve.tag << ' ' << line_element << ' ' << curve.lines.size() << '\n';
    for (const auto& [a, b] : curve.lines) {
      out << ++tag << ' ' << node(a) << ' ' << node(b) << '\n';
    }
  }
  for (const MshSurface& surface : entities.surfaces) {
    out << "2 " << surface.tag << ' ' << triangle_element << ' ' << surface.triangles.size()
        << '\n';
    for (const TriangleId t : surface.triangles) {
      out << ++tag;
      write_triangle_nodes(out, mesh, t);
    }
  }
  out << "$EndElements\n";
}

// ---- format 2.2 --------------------------------------------------------------------------------

// The one group of an entity, 0 for none.
int only_group(const Mesh& mesh, const std::string& file, std::string_view what, int tag,
               const std::vector<GroupId>& groups) {
  if (groups.empty()) return 0;
  if (groups.size() == 1) return mesh.entities()[groups[0]].tag;
  std::string list;
  for (const GroupId g : groups) {
    const PhysicalGroup& group = mesh.entities()[g];
    list += (list.empty() ? "" : ", ") + std::to_string(group.tag);
    if (!group.name.empty()) list += " \"" + group.name + "\"";
  }
  throw InputError(file + ", " + std::string(what) + " " + std::to_string(tag),
                   "is in several physical groups (" + list + "), which format 2.2 cannot hold",
                   "use format msh41");
}

void write_nodes_22(OutputFile& out, const Mesh& mesh, const Places& places) {
  out << "$Nodes\n" << mesh.vertex_count() << '\n';
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    out << i + 1 << ' ' << places[VertexId(i)] << '\n';
  }
  out << "$EndNodes\n";
}

void write_elements_22(OutputFile& out, const Mesh& mesh, const MshEntities& entities,
                       const std::string& file) {
  out << "$Elements\n" << count_elements(mesh, entities).all() << '\n';
  std::size_t tag = 0;
  const auto start = [&](int type, int group, int entity) -> OutputFile& {
    return out << ++tag << ' ' << type << " 2 " << group << ' ' << entity;
  };
  for (const MshPoint& p : entities.points) {
    if (!p.is_written) continue;
    start(point_element, only_group(mesh, file, "point", p.tag, p.groups), p.tag)
        << ' ' << node(p.vertex) << '\n';
  }
  for (const MshCurve& curve : entities.curves) {
    const int group = only_group(mesh, file, "curve", curve.tag, curve.groups);
    for (const auto& [a, b] : curve.lines) {
      start(line_element, group, curve.tag) << ' ' << node(a) << ' ' << node(b) << '\n';
    }
  }
  for (const MshSurface& surface : entities.surfaces) {
    const int group = only_group(mesh, file, "surface", surface.tag, surface.groups);
    for (const TriangleId t : surface.triangles) {
      write_triangle_nodes(start(triangle_element, group, surface.tag), mesh, t);
    }
  }
  out << "$EndElements\n";
}

}  // namespace

void write_msh(const Mesh& mesh, const std::filesystem::path& path, MshFormat format,
               std::span<const double> heights) {
  check_groups(mesh, path.string());
  MshEntities entities = msh_entities(mesh);
  if (format == MshFormat::msh41) leave_nothing_ungrouped(entities);
  const Places places(mesh, heights);
  AtomicFiles files;
  OutputFile& out = files.add(path);
  out << "$MeshFormat\n"
      << (format == MshFormat::msh41 ? "4.1" : "2.2") << " 0 8\n"
      << "$EndMeshFormat\n";
  write_names(out, entities.groups);
  if (format == MshFormat::msh41) {
    write_entities(out, mesh, places, entities);
    write_nodes_41(out, places, entities);
    write_elements_41(out, mesh, entities);
  } else {
    write_nodes_22(out, mesh, places);
    write_elements_22(out, mesh, entities, path.string());
  }
  files.commit();
}

}  // namespace lepp
