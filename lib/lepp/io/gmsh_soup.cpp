#include "lepp/io/gmsh_soup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "lepp/io/gmsh_groups.hpp"
#include "lepp/io/gmsh_rules.hpp"

namespace lepp {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // nodes, the smaller index first

Edge edge_of(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// What lies along an edge of the mesh.
struct EdgeUse {
  std::vector<SurfaceId> sides;  // the surface of each triangle, sorted
  std::optional<int> curve;      // tag of the curve whose line it is
};

class Builder {
 public:
  Builder(const GmshRecord& record, const std::string& source)
      : record_(record), mesh_(*record.mesh), source_(source), groups_(record) {}

  GmshInput build() {
    check_indices();
    soup_.source = source_;
    soup_.base = 1;
    add_surfaces();
    add_triangles();
    check_plane();
    add_lines();
    add_points();
    // The PSLG has its own entities: its curves must know what they bound.
    input_.pslg.source = source_;
    input_.pslg.base = 1;
    input_.pslg.entities.points = soup_.entities.points;
    input_.pslg.entities.surfaces = soup_.entities.surfaces;
    add_outline();
    for (std::string& sentence : groups_.warnings()) warn(std::move(sentence));
    GmshGroups pslg_groups = groups_;
    pslg_groups.finish(input_.pslg.entities);
    groups_.finish(soup_.entities);
    input_.triangles = std::move(soup_);
    return std::move(input_);
  }

 private:
  void warn(std::string sentence) { input_.warnings.push_back(std::move(sentence)); }

  /// The record comes from another process: its indices are checked once.
  void check_indices() const {
    const std::size_t n = mesh_.node_tags.size();
    bool good = mesh_.coordinates.size() == 3 * n;
    for (const GmshTriangle& t : mesh_.triangles)
      for (const std::uint32_t node : t.nodes) good = good && node < n;
    for (const GmshLine& line : mesh_.lines)
      for (const std::uint32_t node : line.nodes) good = good && node < n;
    for (const GmshNodeOfPoint& point : mesh_.points) good = good && point.node < n;
    if (!good)
      throw InputError(source_, "Gmsh returned elements with nodes that do not exist",
                       "write the mesh again");
    if (mesh_.triangles.empty())
      throw InputError(source_, "there are no triangles in the file",
                       "only meshes of 3-node triangles can be read");
  }

  void add_surfaces() {
    for (const GmshSurface& surface : record_.surfaces) {
      surface_ids_[surface.tag] = SurfaceId(soup_.entities.surfaces.size());
      SurfaceEntity& entity = soup_.entities.surfaces.emplace_back();
      entity.tag = surface.tag;
      entity.attribute = surface.tag;
      entity.groups = groups_.ids(2, surface.groups);
    }
  }

  /// The mesh vertex of a node; made when a triangle first has it.
  VertexId vertex(std::uint32_t node) {
    const auto [found, is_new] = vertices_.try_emplace(node, VertexId(soup_.points.size()));
    if (is_new) {
      soup_.points.push_back(position(node));
      soup_.point_numbers.push_back(mesh_.node_tags[node]);
      node_of_.push_back(node);
    }
    return found->second;
  }

  Point position(std::uint32_t node) const {
    return {mesh_.coordinates[3 * std::size_t{node}], mesh_.coordinates[3 * std::size_t{node} + 1]};
  }

  void add_triangles() {
    mark_used_nodes();
    std::set<std::array<std::uint32_t, 3>> seen;
    std::size_t repeated = 0;
    for (const GmshTriangle& t : triangles_by_number()) {
      auto nodes = t.nodes;
      std::sort(nodes.begin(), nodes.end());
      // Gmsh's 2.2 writer stores a triangle once per group of its surface.
      if (!seen.insert(nodes).second) {
        ++repeated;
        continue;
      }
      const SurfaceId surface = surface_ids_.at(t.surface);
      soup_.triangles.push_back({vertex(t.nodes[0]), vertex(t.nodes[1]), vertex(t.nodes[2])});
      soup_.triangle_numbers.push_back(t.tag);
      soup_.regions.push_back(surface);
      for (std::size_t i = 0; i < 3; ++i)
        edges_[edge_of(t.nodes[i], t.nodes[(i + 1) % 3])].sides.push_back(surface);
    }
    if (repeated > 0) warn(fmt::format("{} triangles are in the file more than once", repeated));
  }

  std::vector<GmshTriangle> triangles_by_number() const {
    std::vector<GmshTriangle> triangles = mesh_.triangles;
    std::stable_sort(triangles.begin(), triangles.end(),
                     [](const GmshTriangle& a, const GmshTriangle& b) { return a.tag < b.tag; });
    return triangles;
  }

  /// Vertices come in the order of the file's node numbers; nodes without triangle are left out.
  void mark_used_nodes() {
    std::vector<bool> used(mesh_.node_tags.size());
    for (const GmshTriangle& t : mesh_.triangles)
      for (const std::uint32_t node : t.nodes) used[node] = true;
    std::vector<std::uint32_t> nodes(used.size());
    std::iota(nodes.begin(), nodes.end(), 0U);
    std::sort(nodes.begin(), nodes.end(), [&](std::uint32_t a, std::uint32_t b) {
      return mesh_.node_tags[a] < mesh_.node_tags[b];
    });
    for (const std::uint32_t node : nodes)
      if (used[node]) vertex(node);
    const auto unused = std::count(used.begin(), used.end(), false);
    if (unused > 0)
      warn(fmt::format("{} nodes belong to no triangle and are dropped, the first is node {}",
                       unused,
                       mesh_.node_tags[static_cast<std::size_t>(
                           std::find(used.begin(), used.end(), false) - used.begin())]));
  }

  void check_plane() const {
    Point low = soup_.points.front(), high = low;
    for (const Point p : soup_.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    PlaneCheck same_height(source_, std::max(high.x - low.x, high.y - low.y));
    for (const GmshTriangle& t : mesh_.triangles)
      for (const std::uint32_t node : t.nodes)
        same_height(mesh_.coordinates[3 * std::size_t{node} + 2],
                    fmt::format("node {}", mesh_.node_tags[node]));
  }

  void add_lines() {
    for (const GmshCurve& curve : record_.curves) {
      curve_ids_[curve.tag] = CurveId(soup_.entities.curves.size());
      soup_.entities.curves.push_back(
          {curve.tag, groups_.ids(1, curve.groups), StraightCurve{}, {}});
    }
    std::size_t loose = 0;
    for (const GmshLine& line : mesh_.lines) {
      const auto edge = edges_.find(edge_of(line.nodes[0], line.nodes[1]));
      if (edge == edges_.end()) {
        ++loose;
        continue;
      }
      if (edge->second.curve == line.curve) continue;  // once per group of its curve
      if (!edge->second.curve) edge->second.curve = line.curve;
      soup_.segments.push_back(
          {vertex(line.nodes[0]), vertex(line.nodes[1]), curve_ids_.at(line.curve), 0, 1});
    }
    if (loose > 0) warn(fmt::format("{} lines are no edge of a triangle and are dropped", loose));
  }

  void add_points() {
    std::set<std::pair<int, std::uint32_t>> seen;
    for (const GmshNodeOfPoint& point : mesh_.points) {
      const auto entity = std::find_if(record_.points.begin(), record_.points.end(),
                                       [&](const GmshPoint& p) { return p.tag == point.point; });
      const auto found = vertices_.find(point.node);
      if (entity == record_.points.end() || found == vertices_.end()) continue;
      if (!seen.insert({point.point, point.node}).second) continue;
      soup_.entities.points.push_back({entity->tag, found->second, groups_.ids(0, entity->groups)});
    }
  }

  /// Boundary, interfaces and lines as a PSLG with the mesh's vertices along them.
  void add_outline() {
    using Key = std::pair<int, std::vector<SurfaceId>>;  // curve tag or 0, surfaces that it bounds
    std::map<Key, CurveId> curves;
    std::unordered_map<std::uint32_t, VertexId> outline;
    auto& pslg = input_.pslg;
    const auto outline_vertex = [&](std::uint32_t node) {
      const auto [found, is_new] = outline.try_emplace(node, VertexId(pslg.points.size()));
      if (is_new) {
        pslg.points.push_back(position(node));
        pslg.point_numbers.push_back(mesh_.node_tags[node]);
      }
      return found->second;
    };
    for (auto& [edge, use] : edges_) {
      std::sort(use.sides.begin(), use.sides.end());
      const bool inside = use.sides.size() == 2 && use.sides[0] == use.sides[1];
      if (inside && !use.curve) continue;
      const Key key{use.curve.value_or(0), inside ? std::vector<SurfaceId>{} : use.sides};
      const auto [found, is_new] = curves.try_emplace(key, CurveId(pslg.entities.curves.size()));
      if (is_new) {
        CurveEntity entity;
        if (use.curve) entity = soup_.entities.curves[curve_ids_.at(*use.curve).index()];
        entity.bounds = key.second;
        pslg.entities.curves.push_back(std::move(entity));
      }
      pslg.segments.push_back(
          {outline_vertex(edge.first), outline_vertex(edge.second), found->second, 0, 1});
    }
    for (PointEntity& point : pslg.entities.points)
      point.vertex = outline_vertex(node_of_[point.vertex.index()]);
  }

  const GmshRecord& record_;
  const GmshMesh& mesh_;
  const std::string& source_;
  GmshGroups groups_;
  GmshInput input_;
  TriangleSoup soup_;
  std::map<int, SurfaceId> surface_ids_;
  std::map<int, CurveId> curve_ids_;
  std::unordered_map<std::uint32_t, VertexId> vertices_;
  std::vector<std::uint32_t> node_of_;  // of each vertex
  std::map<Edge, EdgeUse> edges_;
};

}  // namespace

GmshInput soup_from_gmsh(const GmshRecord& record, const std::string& source) {
  return Builder(record, source).build();
}

}  // namespace lepp
