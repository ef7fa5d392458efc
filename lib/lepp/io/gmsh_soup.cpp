#include "lepp/io/gmsh_soup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "lepp/geometry/predicates.hpp"
#include "lepp/io/gmsh_groups.hpp"
#include "lepp/io/gmsh_mesh_entities.hpp"
#include "lepp/io/gmsh_rules.hpp"

namespace lepp {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // nodes, the smaller index first

Edge edge_of(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// What lies along an edge of the mesh.
struct EdgeUse {
  std::vector<SurfaceId> sides;  // the surface of each triangle
  std::optional<CurveId> curve;  // the curve whose line it is
};

template <class Items>
std::map<int, std::vector<int>> groups_by_tag(const Items& items) {
  std::map<int, std::vector<int>> result;
  for (const auto& item : items) result[item.tag] = item.groups;
  return result;
}

class Builder {
 public:
  Builder(const GmshRecord& record, const ElementGroups& old_groups, const std::string& source)
      : record_(record),
        mesh_(*record.mesh),
        old_groups_(old_groups),
        source_(source),
        groups_(record),
        curves_(groups_by_tag(record.curves), old_groups),
        surfaces_(groups_by_tag(record.surfaces), old_groups) {}

  GmshInput build() {
    check_indices();
    input_.pslg.source = soup_.source = source_;
    input_.pslg.base = soup_.base = 1;
    add_vertices();
    check_plane();
    add_triangles();
    add_lines();
    add_points();
    add_entities();
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

  /// Vertices come in the order of the file's node numbers; nodes without triangle are left out.
  void add_vertices() {
    std::vector<bool> used(mesh_.node_tags.size());
    for (const GmshTriangle& t : mesh_.triangles)
      for (const std::uint32_t node : t.nodes) used[node] = true;
    std::vector<std::uint32_t> nodes(used.size()), unused;
    std::iota(nodes.begin(), nodes.end(), 0U);
    std::sort(nodes.begin(), nodes.end(), [&](std::uint32_t a, std::uint32_t b) {
      return mesh_.node_tags[a] < mesh_.node_tags[b];
    });
    for (const std::uint32_t node : nodes) {
      if (!used[node]) {
        unused.push_back(node);
        continue;
      }
      vertices_[node] = VertexId(soup_.points.size());
      soup_.points.push_back(position(node));
      soup_.point_numbers.push_back(mesh_.node_tags[node]);
      node_of_.push_back(node);
    }
    if (!unused.empty())
      warn(fmt::format("{} nodes belong to no triangle and are dropped, the first is node {}",
                       unused.size(), mesh_.node_tags[unused.front()]));
  }

  Point position(std::uint32_t node) const {
    return {mesh_.coordinates[3 * std::size_t{node}], mesh_.coordinates[3 * std::size_t{node} + 1]};
  }

  /// A terrain, whose triangles all face up, is read in plan; other meshes have to be plane.
  void check_plane() {
    const auto [low, high] = heights();
    if (low == high) return;
    if (!all_face_up()) return refuse_other_planes();
    warn(fmt::format("a terrain, from z = {} to {}: read in plan, without its heights", low, high));
  }

  std::pair<double, double> heights() const {
    double low = z(node_of_.front()), high = low;
    for (const std::uint32_t node : node_of_) {
      low = std::min(low, z(node));
      high = std::max(high, z(node));
    }
    return {low, high};
  }
  double z(std::uint32_t node) const { return mesh_.coordinates[3 * std::size_t{node} + 2]; }

  bool all_face_up() const {
    return std::ranges::all_of(mesh_.triangles, [&](const GmshTriangle& t) {
      return orient2d(position(t.nodes[0]), position(t.nodes[1]), position(t.nodes[2])) > 0;
    });
  }

  void refuse_other_planes() const {
    Point low = soup_.points.front(), high = low;
    for (const Point p : soup_.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    PlaneCheck same_height(source_, std::max(high.x - low.x, high.y - low.y));
    for (const std::uint32_t node : node_of_)
      same_height(z(node), fmt::format("node {}", mesh_.node_tags[node]));
  }

  /// A triangle stands in the file once for each group of its surface; it is taken once.
  void add_triangles() {
    using Key = std::pair<std::array<std::uint32_t, 3>, int>;  // nodes in order, surface tag
    std::map<Key, std::vector<std::int64_t>> copies;
    const auto key = [](const GmshTriangle& t) {
      Key result{t.nodes, t.surface};
      std::sort(result.first.begin(), result.first.end());
      return result;
    };
    for (const GmshTriangle& t : mesh_.triangles) copies[key(t)].push_back(t.tag);
    std::vector<const GmshTriangle*> in_order;
    for (const GmshTriangle& t : mesh_.triangles)
      if (copies[key(t)].front() == t.tag) in_order.push_back(&t);
    std::sort(in_order.begin(), in_order.end(),
              [](const GmshTriangle* a, const GmshTriangle* b) { return a->tag < b->tag; });
    for (const GmshTriangle* t : in_order) {
      const auto groups = surfaces_.groups_of(copies[key(*t)]);
      const SurfaceId surface(surfaces_.index(t->surface, groups));
      const auto& [a, b, c] = t->nodes;
      soup_.triangles.push_back({vertices_[a], vertices_[b], vertices_[c]});
      soup_.triangle_numbers.push_back(t->tag);
      soup_.regions.push_back(surface);
      for (const Edge& edge : {edge_of(a, b), edge_of(b, c), edge_of(c, a)})
        edges_[edge].sides.push_back(surface);
    }
    const std::size_t repeated = mesh_.triangles.size() - in_order.size();
    if (repeated > 0 && old_groups_.empty())
      warn(fmt::format("{} triangles are in the file more than once", repeated));
  }

  void add_lines() {
    std::map<std::pair<Edge, int>, std::vector<std::int64_t>> copies;  // edge and curve tag
    for (const GmshLine& line : mesh_.lines)
      copies[{edge_of(line.nodes[0], line.nodes[1]), line.curve}].push_back(line.tag);
    std::size_t loose = 0;
    for (const GmshLine& line : mesh_.lines) {
      const Edge nodes = edge_of(line.nodes[0], line.nodes[1]);
      const auto& same = copies[{nodes, line.curve}];
      if (same.front() != line.tag) continue;
      const auto edge = edges_.find(nodes);
      if (edge == edges_.end()) {
        ++loose;
        continue;
      }
      const CurveId curve(curves_.index(line.curve, curves_.groups_of(same)));
      if (!edge->second.curve) edge->second.curve = curve;
      soup_.segments.push_back({vertices_[line.nodes[0]], vertices_[line.nodes[1]], curve, 0, 1});
    }
    if (loose > 0) warn(fmt::format("{} lines are no edge of a triangle and are dropped", loose));
  }

  void add_points() {
    const auto known = groups_by_tag(record_.points);
    std::map<std::pair<int, std::uint32_t>, std::vector<std::int64_t>> copies;
    for (const GmshNodeOfPoint& point : mesh_.points)
      copies[{point.point, point.node}].push_back(point.tag);
    for (const auto& [key, elements] : copies) {
      const auto vertex = vertices_.find(key.second);
      if (vertex == vertices_.end()) continue;
      const auto groups = old_groups_.empty() ? known.at(key.first) : surfaces_.groups_of(elements);
      soup_.entities.points.push_back({key.first, vertex->second, groups_.ids(0, groups)});
    }
  }

  void add_entities() {
    for (const auto& [tag, groups] : curves_.entities())
      soup_.entities.curves.push_back({tag, groups_.ids(1, groups), StraightCurve{}, {}});
    for (const auto& [tag, groups] : surfaces_.entities()) {
      SurfaceEntity& surface = soup_.entities.surfaces.emplace_back();
      surface.tag = tag;
      surface.attribute = tag;
      surface.groups = groups_.ids(2, groups);
    }
    // The PSLG has curves of its own: they must know what they bound.
    input_.pslg.entities.points = soup_.entities.points;
    input_.pslg.entities.surfaces = soup_.entities.surfaces;
  }

  VertexId outline_vertex(std::uint32_t node) {
    auto& pslg = input_.pslg;
    const auto [found, is_new] = outline_.try_emplace(node, VertexId(pslg.points.size()));
    if (is_new) {
      pslg.points.push_back(position(node));
      pslg.point_numbers.push_back(mesh_.node_tags[node]);
    }
    return found->second;
  }

  /// Boundary, interfaces and lines as a PSLG with the mesh's vertices along them.
  void add_outline() {
    using Key = std::pair<std::optional<CurveId>, std::vector<SurfaceId>>;  // and what it bounds
    std::map<Key, CurveId> curves;
    auto& pslg = input_.pslg;
    for (auto& [edge, use] : edges_) {
      std::sort(use.sides.begin(), use.sides.end());
      const bool inside = use.sides.size() == 2 && use.sides[0] == use.sides[1];
      if (inside && !use.curve) continue;
      const Key key{use.curve, inside ? std::vector<SurfaceId>{} : use.sides};
      const auto [found, is_new] = curves.try_emplace(key, CurveId(pslg.entities.curves.size()));
      if (is_new) {
        CurveEntity& curve = pslg.entities.curves.emplace_back();
        if (use.curve) curve = soup_.entities.curves[use.curve->index()];
        curve.bounds = key.second;
      }
      pslg.segments.push_back(
          {outline_vertex(edge.first), outline_vertex(edge.second), found->second, 0, 1});
    }
    for (PointEntity& point : pslg.entities.points)
      point.vertex = outline_vertex(node_of_[point.vertex.index()]);
  }

  const GmshRecord& record_;
  const GmshMesh& mesh_;
  const ElementGroups& old_groups_;
  const std::string& source_;
  GmshGroups groups_;
  GmshMeshEntities curves_, surfaces_;
  GmshInput input_;
  TriangleSoup soup_;
  std::unordered_map<std::uint32_t, VertexId> vertices_;  // by node
  std::vector<std::uint32_t> node_of_;                    // of each vertex
  std::unordered_map<std::uint32_t, VertexId> outline_;   // vertices of the PSLG by node
  std::map<Edge, EdgeUse> edges_;
};

}  // namespace

GmshInput soup_from_gmsh(const GmshRecord& record, const ElementGroups& old_groups,
                         const std::string& source) {
  return Builder(record, old_groups, source).build();
}

}  // namespace lepp
