#include "lepp/nonobtuse/nonobtuse.hpp"

#include <algorithm>
#include <cmath>

#include "lepp/triangulation/encroached.hpp"
#include "lepp/triangulation/lepp.hpp"
#include "lepp/triangulation/split_constrained.hpp"
#include "lepp/triangulation/unfinished.hpp"

namespace lepp {

namespace {

class Eliminator {
 public:
  Eliminator(Mesh& mesh, const NonobtuseOptions& options)
      : mesh_(mesh),
        floor_(default_size_floor(mesh)),
        budget_(options.max_vertices > 0 ? options.max_vertices
                                         : 50 * (mesh.vertex_count() + 1000)) {}

  // Between two turns the mesh satisfies M1 to M6. Ends: each turn adds a vertex, of which there
  // are at most `budget_`, or drops an entry for good.
  NonobtuseReport run() {
    const std::size_t at_start = mesh_.vertex_count();
    EncroachedEdges obtuse(mesh_);
    while (mesh_.vertex_count() < budget_) {
      const auto e = obtuse.next(mesh_);
      if (!e) break;
      changed_.clear();
      eliminate(*e);
      obtuse.update(mesh_, changed_);
    }
    report_.steiner_points = mesh_.vertex_count() - at_start;
    list_what_is_left();
    return std::move(report_);
  }

 private:
  // The obtuse angle faces e, so e is the longest edge of its triangle.
  void eliminate(HalfEdge e) {
    const auto [shortest, medium, longest] = edges_by_length(mesh_, e.triangle);
    if (mesh_.is_constrained(medium) && !mesh_.is_constrained(shortest)) {
      ++report_.two_edge;
      cut_off_corner(medium, e);
      return;
    }
    count_one_edge(e);
    keep(split_halfway(mesh_, e, floor_));
  }

  void count_one_edge(HalfEdge e) {
    const auto across = mesh_.twin(e);
    if (!across) {
      ++report_.one_edge_boundary;
    } else {
      report_.one_edge_interface += faces_obtuse_angle(mesh_, *across) ? 2 : 1;
    }
  }

  // Two constrained edges at B: medium BC and longest BA. The isosceles triangle BMN replaces the
  // tip, because halving both edges in turn would only repeat the triangle at half the scale.
  //
  //        C                 M halfway on BC, N on BA with |BN| = |BM|
  //      / |
  //    M   |
  //   / \  |
  //  B---N-A
  void cut_off_corner(HalfEdge medium, HalfEdge longest) {
    const VertexId b = common_end(medium, longest);
    const VertexId a =
        mesh_.origin(longest) == b ? mesh_.destination(longest) : mesh_.origin(longest);
    const ConstrainedSplit at_m = split_halfway(mesh_, medium, floor_);
    keep(at_m);
    if (at_m.vertices.empty()) return;
    const Point m = mesh_.point(at_m.vertices.front());
    const double radius = std::sqrt(squared_distance(mesh_.point(b), m));
    if (const auto ba = edge_among(at_m.changed, longest.triangle, b, a)) {
      keep(split_at_distance(mesh_, *ba, b, radius, floor_));
    }
  }

  VertexId common_end(HalfEdge e, HalfEdge f) const {
    const VertexId o = mesh_.origin(e);
    return o == mesh_.origin(f) || o == mesh_.destination(f) ? o : mesh_.destination(e);
  }

  // The edge ab, which lies in `before` or in one of the triangles that changed since.
  std::optional<HalfEdge> edge_among(const std::vector<TriangleId>& changed, TriangleId before,
                                     VertexId a, VertexId b) const {
    const auto in = [&](TriangleId t) -> std::optional<HalfEdge> {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge e{t, i};
        if (std::minmax(mesh_.origin(e), mesh_.destination(e)) == std::minmax(a, b)) return e;
      }
      return std::nullopt;
    };
    if (const auto found = in(before)) return found;
    for (const TriangleId t : changed) {
      if (const auto found = in(t)) return found;
    }
    return std::nullopt;
  }

  void keep(const ConstrainedSplit& split) {
    changed_.insert(changed_.end(), split.changed.begin(), split.changed.end());
  }

  void list_what_is_left() {
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge e{TriangleId(t), i};
        if (mesh_.is_constrained(e) && faces_obtuse_angle(mesh_, e)) {
          report_.obtuse.push_back(TriangleId(t));
        }
      }
    }
    report_.goal_reached = report_.obtuse.empty();
  }

  Mesh& mesh_;
  double floor_;
  std::size_t budget_;
  NonobtuseReport report_;
  std::vector<TriangleId> changed_;
};

}  // namespace

NonobtuseReport make_boundary_nonobtuse(Mesh& mesh, const NonobtuseOptions& options) {
  return Eliminator(mesh, options).run();
}

}  // namespace lepp
