#include <algorithm>
#include <map>

#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/triangulation/boundary_meetings.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"

namespace lepp {

namespace {

class SoupJoiner {
 public:
  explicit SoupJoiner(const TriangleSoup& soup) : soup_(soup) {}

  Triangulation run() {
    if (soup_.triangles.empty()) {
      throw InputError(soup_.source, "has no triangles", "give a mesh with at least one triangle");
    }
    mesh_.set_source(soup_.source, soup_.base);
    mesh_.set_entities(soup_.entities);
    if (mesh_.entities().surfaces.empty()) mesh_.mutable_entities().surfaces.emplace_back();
    check_points();
    check_ids();
    add_vertices();
    add_triangles();
    link_triangles();
    constrain_edges();
    check_boundary();
    keep_point_entities();
    return {std::move(mesh_), std::move(report_)};
  }

 private:
  static std::string number(const std::vector<std::int64_t>& numbers, std::size_t i,
                            std::int64_t base) {
    return std::to_string(i < numbers.size() ? numbers[i] : base + static_cast<std::int64_t>(i));
  }
  std::string point_number(VertexId v) const {
    return number(soup_.point_numbers, v.index(), soup_.base);
  }
  std::string triangle_number(std::size_t t) const {
    return number(soup_.triangle_numbers, t, soup_.base);
  }
  // The user's number of a vertex of the mesh.
  std::string vertex_number(VertexId v) const {
    return point_number(VertexId(mesh_.origin_of(v).index));
  }

  void check_points() const {
    Pslg points;
    points.points = soup_.points;
    points.point_numbers = soup_.point_numbers;
    points.base = soup_.base;
    points.source = soup_.source;
    check_ids_and_range(points);
  }

  void check_ids() const {
    const Entities& entities = mesh_.entities();
    check_entities(entities, soup_.points.size(), soup_.source);
    const auto refuse = [&](const std::string& what) {
      throw InputError(soup_.source, what, "correct the ids of the triangle soup");
    };
    if (!soup_.regions.empty() && soup_.regions.size() != soup_.triangles.size()) {
      refuse("has " + std::to_string(soup_.regions.size()) + " regions for " +
             std::to_string(soup_.triangles.size()) + " triangles");
    }
    for (const SurfaceId region : soup_.regions) {
      if (region.index() >= entities.surfaces.size()) refuse("a triangle's region does not exist");
    }
    for (const Segment& s : soup_.segments) {
      const bool ends = std::max(s.a, s.b).index() < soup_.points.size();
      if (!ends) refuse("an end of a segment does not exist");
      if (s.curve && s.curve->index() >= entities.curves.size()) {
        refuse("the curve of a segment does not exist");
      }
    }
  }

  void add_vertices() {
    std::vector<bool> used(soup_.points.size(), false);
    for (std::size_t t = 0; t < soup_.triangles.size(); ++t) {
      for (const VertexId v : soup_.triangles[t]) {
        if (v.index() >= used.size()) {
          throw InputError(soup_.source + ", triangle " + triangle_number(t),
                           "refers to point " +
                               std::to_string(soup_.base + static_cast<std::int64_t>(v.index())) +
                               ", which does not exist",
                           "the " + std::to_string(used.size()) + " points are numbered from " +
                               std::to_string(soup_.base));
        }
        used[v.index()] = true;
      }
    }
    vertex_.resize(used.size());
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (!used[i]) continue;
      vertex_[i] = mesh_.add_vertex(soup_.points[i],
                                    {VertexOrigin::Kind::input, static_cast<std::uint32_t>(i)});
    }
    report_.vertex_of_point = vertex_;
    report_.points_outside = used.size() - mesh_.vertex_count();
    if (report_.points_outside > 0) {
      report_.warnings.push_back(std::to_string(report_.points_outside) +
                                 " points belong to no triangle: dropped");
    }
  }

  void add_triangles() {
    for (std::size_t t = 0; t < soup_.triangles.size(); ++t) {
      auto [a, b, c] = soup_.triangles[t];
      const int turn =
          orient2d(soup_.points[a.index()], soup_.points[b.index()], soup_.points[c.index()]);
      if (turn == 0) {
        throw InputError(soup_.source + ", triangle " + triangle_number(t),
                         "has zero area at " + to_text(soup_.points[a.index()]),
                         "remove it or move one of its points");
      }
      if (turn < 0) std::swap(b, c);
      const SurfaceId region = soup_.regions.empty() ? SurfaceId(0U) : soup_.regions[t];
      mesh_.add_triangle(*vertex_[a.index()], *vertex_[b.index()], *vertex_[c.index()], region);
    }
  }

  void link_triangles() {
    struct Side {
      VertexId low, high;
      HalfEdge e;
    };
    std::vector<Side> sides;
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge e{TriangleId(t), i};
        const auto [low, high] = std::minmax({mesh_.origin(e), mesh_.destination(e)});
        sides.push_back({low, high, e});
      }
    }
    std::ranges::sort(sides, {}, [](const Side& s) { return std::tuple(s.low, s.high, s.e); });
    const auto same = [&](std::size_t i, std::size_t j) {
      return j < sides.size() && sides[i].low == sides[j].low && sides[i].high == sides[j].high;
    };
    for (std::size_t i = 0; i < sides.size();) {
      if (!same(i, i + 1)) {
        mesh_.unlink(sides[i].e);
        i += 1;
        continue;
      }
      if (same(i, i + 2)) throw crowded_edge(sides[i].low, sides[i].high);
      join(sides[i].e, sides[i + 1].e);
      i += 2;
    }
  }

  InputError crowded_edge(VertexId a, VertexId b) const {
    return {soup_.source + ", edge " + vertex_number(a) + "-" + vertex_number(b),
            "has three or more triangles, at " + to_text(mesh_.point(a)),
            "an edge of a plane mesh has at most two; remove the others"};
  }

  void join(HalfEdge e, HalfEdge f) {
    if (mesh_.origin(e) == mesh_.origin(f)) {
      throw InputError(soup_.source + ", triangles " + triangle_number(e.triangle.index()) +
                           " and " + triangle_number(f.triangle.index()),
                       "overlap: they lie on the same side of edge " +
                           vertex_number(mesh_.origin(e)) + "-" +
                           vertex_number(mesh_.destination(e)),
                       "remove one of them");
    }
    mesh_.link(e, f);
  }

  // Edges to keep become segments: the given ones first, then what the boundary and the regions
  // need besides.
  void constrain_edges() {
    std::map<std::pair<VertexId, VertexId>, HalfEdge> edges;
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge e{TriangleId(t), i};
        edges.try_emplace(std::minmax(mesh_.origin(e), mesh_.destination(e)), e);
      }
    }
    std::vector<Segment> segments;
    std::vector<HalfEdge> edge_of;
    for (Segment s : soup_.segments) {
      const auto& a = vertex_[s.a.index()];
      const auto& b = vertex_[s.b.index()];
      const auto found = a && b ? edges.find(std::minmax(*a, *b)) : edges.end();
      if (found == edges.end()) {
        ++report_.segments_outside;
        continue;
      }
      s.a = *a;
      s.b = *b;
      segments.push_back(s);
      edge_of.push_back(found->second);
    }
    if (report_.segments_outside > 0) {
      report_.warnings.push_back(std::to_string(report_.segments_outside) +
                                 " line elements are no edge of a triangle: dropped");
    }
    std::vector<bool> given(3 * mesh_.triangle_count(), false);
    for (const HalfEdge e : edge_of) given[3 * e.triangle.index() + e.edge] = true;
    for (const auto& [ends, e] : edges) {
      if (given[3 * e.triangle.index() + e.edge] || !mesh_.separates_regions(e)) continue;
      segments.push_back({ends.first, ends.second, {}, 0, 1});
      edge_of.push_back(e);
    }
    mesh_.set_segments(std::move(segments));
    std::vector<SegmentId> again;
    for (std::size_t s = 0; s < edge_of.size(); ++s) {
      const HalfEdge e = edge_of[s];
      if (mesh_.is_constrained(e)) again.emplace_back(s);
      mesh_.set_constrained_flag(e, true);
      if (const auto across = mesh_.twin(e)) mesh_.set_constrained_flag(*across, true);
    }
    mesh_.own_edges(again);
  }

  // Boundary edges that meet elsewhere than at their ends mean triangles that overlap, or a
  // vertex that hangs in the middle of an edge.
  void check_boundary() const {
    const auto meeting = first_boundary_meeting(mesh_);
    if (!meeting) return;
    const auto name = [&](HalfEdge e) {
      return vertex_number(mesh_.origin(e)) + "-" + vertex_number(mesh_.destination(e));
    };
    throw InputError(
        soup_.source + ", boundary edges " + name(meeting->first) + " and " + name(meeting->second),
        "cross, touch or overlap near " + to_text(mesh_.point(mesh_.origin(meeting->first))),
        "triangles must meet along whole edges and not overlap");
  }

  void keep_point_entities() {
    std::vector<PointEntity> inside;
    for (PointEntity point : soup_.entities.points) {
      const auto& vertex = vertex_[point.vertex.index()];
      if (!vertex) continue;
      point.vertex = *vertex;
      inside.push_back(std::move(point));
    }
    mesh_.mutable_entities().points = std::move(inside);
  }

  const TriangleSoup& soup_;
  Mesh mesh_;
  TriangulationReport report_;
  std::vector<std::optional<VertexId>> vertex_;
};

}  // namespace

Triangulation mesh_from_triangles(const TriangleSoup& soup) { return SoupJoiner(soup).run(); }

}  // namespace lepp
