#include "lepp/io/geo.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "lepp/geometry/error.hpp"
#include "lepp/io/atomic_files.hpp"
#include "lepp/io/loops.hpp"
#include "lepp/io/ungrouped.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"

namespace lepp {

namespace {

void check_names(const Entities& entities, const std::string& file) {
  for (const PhysicalGroup& group : entities.groups) {
    if (group.name.find_first_of("\"\n\r") == std::string::npos) continue;
    throw InputError(file + ", physical group " + std::to_string(group.tag),
                     "its name has a double quote or a line end",
                     "rename the group: a .geo file cannot hold that name");
  }
}

// Which vertices without constrained edge become points of the geometry.
enum class LonePoints {
  all,         ///< of a PSLG: the user put each of them there
  only_named,  ///< of a mesh: the others are its interior vertices
};

// Writes the outline of a mesh. Vertex i is Point i + 1, constrained edge i is Line i + 1,
// part i is Curve Loop and Plane Surface.
class GeoFile {
 public:
  GeoFile(OutputFile& out, const Mesh& mesh) : out_(out), mesh_(mesh), outline_(outline(mesh)) {}

  void write(LonePoints lone) {
    find_points(lone);
    points();
    lines();
    surfaces();
    embedded_points();
    groups();
  }

 private:
  void find_points(LonePoints lone);
  void points();
  void lines();
  void surfaces();
  void embedded_points();
  void groups();
  void list(std::string_view opening, const std::vector<std::size_t>& tags);
  void group(const PhysicalGroup& group, const std::vector<std::size_t>& tags);
  std::vector<std::size_t> members(GroupId id) const;
  std::vector<std::size_t> lines_in(GroupId id) const;

  OutputFile& out_;
  const Mesh& mesh_;
  MeshOutline outline_;
  std::vector<bool> on_line_, is_point_;
};

bool is_in(GroupId id, const std::vector<GroupId>& groups) {
  return std::ranges::find(groups, id) != groups.end();
}

void GeoFile::find_points(LonePoints lone) {
  on_line_.assign(mesh_.vertex_count(), false);
  for (const HalfEdge e : outline_.edges) {
    on_line_[mesh_.origin(e).index()] = on_line_[mesh_.destination(e).index()] = true;
  }
  is_point_ = on_line_;
  if (lone == LonePoints::all) is_point_.assign(is_point_.size(), true);
  for (const PointEntity& p : mesh_.entities().points) {
    if (p.vertex.index() < is_point_.size()) is_point_[p.vertex.index()] = true;
  }
}

void GeoFile::points() {
  for (std::size_t i = 0; i < mesh_.vertex_count(); ++i) {
    if (!is_point_[i]) continue;
    const Point p = mesh_.point(VertexId(i));
    out_ << "Point(" << i + 1 << ") = {" << p.x << ", " << p.y << ", 0};\n";
  }
}

void GeoFile::lines() {
  for (std::size_t i = 0; i < outline_.edges.size(); ++i) {
    const HalfEdge e = outline_.edges[i];
    out_ << "Line(" << i + 1 << ") = {" << mesh_.origin(e).value + 1 << ", "
         << mesh_.destination(e).value + 1 << "};\n";
  }
}

void GeoFile::list(std::string_view opening, const std::vector<std::size_t>& tags) {
  out_ << opening << '{';
  for (std::size_t i = 0; i < tags.size(); ++i) out_ << (i == 0 ? "" : ", ") << tags[i];
}

void GeoFile::surfaces() {
  std::size_t loops = 0;
  for (std::size_t i = 0; i < outline_.parts.size(); ++i) {
    const OutlinePart& part = outline_.parts[i];
    std::vector<std::size_t> tags;
    for (const Loop& loop : part.loops) {  // the outer one first
      tags.push_back(++loops);
      out_ << "Curve Loop(" << loops << ") = {";
      for (std::size_t k = 0; k < loop.size(); ++k) {
        out_ << (k == 0 ? "" : ", ") << (loop[k].along ? "" : "-") << loop[k].edge + 1;
      }
      out_ << "};\n";
    }
    list("Plane Surface(" + std::to_string(i + 1) + ") = ", tags);
    out_ << "};\n";
    if (part.embedded.empty()) continue;
    std::vector<std::size_t> inside;
    for (const std::size_t e : part.embedded) inside.push_back(e + 1);
    list("Curve", inside);
    out_ << "} In Surface{" << i + 1 << "};\n";
  }
}

void GeoFile::embedded_points() {
  std::vector<std::vector<std::size_t>> inside(outline_.parts.size());
  for (std::size_t i = 0; i < mesh_.vertex_count(); ++i) {
    if (!is_point_[i] || on_line_[i]) continue;
    const TriangleId t = mesh_.leaving(VertexId(i)).triangle;
    inside[outline_.part_of_triangle[t.index()]].push_back(i + 1);
  }
  for (std::size_t part = 0; part < inside.size(); ++part) {
    if (inside[part].empty()) continue;
    list("Point", inside[part]);
    out_ << "} In Surface{" << part + 1 << "};\n";
  }
}

std::vector<std::size_t> GeoFile::lines_in(GroupId id) const {
  std::vector<std::size_t> lines;
  for (std::size_t i = 0; i < outline_.edges.size(); ++i) {
    const bool in_group =
        std::ranges::any_of(mesh_.segments_of(outline_.edges[i]), [&](SegmentId s) {
          const auto curve = mesh_.segments()[s.index()].curve;
          return curve && is_in(id, mesh_.entities()[*curve].groups);
        });
    if (in_group) lines.push_back(i + 1);
  }
  return lines;
}

std::vector<std::size_t> GeoFile::members(GroupId id) const {
  const Entities& entities = mesh_.entities();
  std::vector<std::size_t> tags;
  switch (entities[id].dimension) {
    case 0:
      for (const PointEntity& p : entities.points) {
        if (is_in(id, p.groups) && p.vertex.index() < is_point_.size()) {
          tags.push_back(p.vertex.index() + 1);
        }
      }
      return tags;
    case 1:
      return lines_in(id);
    default:
      for (std::size_t i = 0; i < outline_.parts.size(); ++i) {
        const std::size_t region = outline_.parts[i].region.index();
        if (region < entities.surfaces.size() && is_in(id, entities.surfaces[region].groups)) {
          tags.push_back(i + 1);
        }
      }
      return tags;
  }
}

void GeoFile::group(const PhysicalGroup& group, const std::vector<std::size_t>& tags) {
  constexpr std::string_view kinds[] = {"Point", "Curve", "Surface"};
  if (tags.empty()) return;
  out_ << "Physical " << kinds[std::clamp(group.dimension, 0, 2)] << '(';
  if (!group.name.empty()) out_ << '"' << group.name << "\", ";
  list(std::to_string(group.tag) + ") = ", tags);
  out_ << "};\n";
}

void GeoFile::groups() {
  const Entities& entities = mesh_.entities();
  for (std::size_t i = 0; i < entities.groups.size(); ++i) {
    group(entities.groups[i], members(GroupId(i)));
  }
  if (entities.groups.empty()) return;
  std::vector<std::size_t> rest;  // Gmsh saves only what has a group, once there is one
  for (std::size_t i = 0; i < outline_.parts.size(); ++i) {
    const std::size_t region = outline_.parts[i].region.index();
    if (region >= entities.surfaces.size() || entities.surfaces[region].groups.empty()) {
      rest.push_back(i + 1);
    }
  }
  group(ungrouped(entities.groups, 2), rest);
}

void write(const Mesh& mesh, const std::filesystem::path& path, LonePoints lone) {
  check_names(mesh.entities(), path.string());
  AtomicFiles files;
  GeoFile(files.add(path), mesh).write(lone);
  files.commit();
}

}  // namespace

void write_geo(const Pslg& pslg, const std::filesystem::path& path) {
  write(constrained_delaunay(pslg).mesh, path, LonePoints::all);
}

void write_geo(const Mesh& mesh, const std::filesystem::path& path) {
  write(mesh, path, LonePoints::only_named);
}

}  // namespace lepp
