#include <algorithm>
#include <numeric>

#include "support/plain/regions.hpp"

namespace lepp::plain {

namespace {

// One edge of one segment.
struct Piece {
  SegmentId of;  // in the old mesh
  Segment segment;
};

class Extractor {
 public:
  Extractor(const Mesh& from, const std::vector<std::optional<SurfaceId>>& regions,
            TriangulationReport& report)
      : from_(from), regions_(regions), report_(report) {}

  Mesh run() {
    to_.set_source(from_.source(), from_.base());
    copy_vertices();
    copy_triangles();
    link_triangles();
    copy_segments();
    keep_point_entities();
    return std::move(to_);
  }

 private:
  bool kept(TriangleId t) const { return regions_[t.index()].has_value(); }
  bool kept(HalfEdge e) const {
    const auto across = from_.twin(e);
    return kept(e.triangle) || (across && kept(across->triangle));
  }

  void copy_vertices() {
    std::vector<bool> used(from_.vertex_count(), false);
    for (std::size_t t = 0; t < from_.triangle_count(); ++t) {
      if (!kept(TriangleId(t))) continue;
      for (const VertexId v : from_.vertices(TriangleId(t))) used[v.index()] = true;
    }
    const auto count = static_cast<std::size_t>(std::ranges::count(used, true));
    report_.points_outside = used.size() - count;
    vertex_.resize(used.size());
    for (std::size_t v = 0; v < used.size(); ++v) {
      const VertexId old(v);
      if (used[v]) vertex_[v] = to_.add_vertex(from_.point(old), from_.origin_of(old));
    }
  }

  void copy_triangles() {
    triangle_.resize(from_.triangle_count());
    for (std::size_t t = 0; t < from_.triangle_count(); ++t) {
      if (!kept(TriangleId(t))) continue;
      const auto& [a, b, c] = from_.vertices(TriangleId(t));
      triangle_[t] = to_.add_triangle(*vertex_[a.index()], *vertex_[b.index()], *vertex_[c.index()],
                                      *regions_[t]);
    }
  }

  void link_triangles() {
    for (std::size_t t = 0; t < from_.triangle_count(); ++t) {
      if (!kept(TriangleId(t))) continue;
      for (std::uint32_t i = 0; i < 3; ++i) {
        const auto across = from_.twin({TriangleId(t), i});
        const HalfEdge e{*triangle_[t], i};
        if (across && kept(across->triangle)) {
          to_.link(e, {*triangle_[across->triangle.index()], across->edge});
        } else {
          to_.unlink(e);
        }
      }
    }
  }

  // Calls visit(edge) once for each constrained edge of the old mesh, in triangle order.
  template <class Visit>
  void for_each_constrained_edge(Visit visit) const {
    for (std::size_t t = 0; t < from_.triangle_count(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge e{TriangleId(t), i};
        if (!from_.is_constrained(e)) continue;
        const auto across = from_.twin(e);
        if (!across || e < *across) visit(e);
      }
    }
  }

  // Each edge inside becomes a segment of its own for each segment that owns it: before refinement
  // the vertices are those of the input, so a segment ends at every one it passes through, and
  // edges that meet there are known to meet.
  void copy_segments() {
    std::vector<std::size_t> edges(from_.segments().size(), 0), inside(edges);
    std::vector<Piece> pieces;
    for_each_constrained_edge([&](HalfEdge e) {
      const auto [t_a, t_b] = parameters(e);
      for (const SegmentId s : from_.segments_of(e)) {
        ++edges[s.index()];
        if (!kept(e)) continue;
        ++inside[s.index()];
        const Segment& whole = from_.segments()[s.index()];
        Segment piece{new_vertex(from_.origin(e)), new_vertex(from_.destination(e)), whole.curve,
                      t_a, t_b};
        if (!runs_along(e, whole)) {
          std::swap(piece.a, piece.b);
          std::swap(piece.t_a, piece.t_b);
        }
        pieces.push_back({s, piece});
      }
    });
    for (std::size_t s = 0; s < edges.size(); ++s) {
      if (inside[s] < edges[s]) ++report_.segments_outside;
    }
    to_.set_segments(in_input_order(pieces));
    own_edges();
  }

  bool runs_along(HalfEdge e, const Segment& s) const {
    const auto along = [&](VertexId a, VertexId b) { return from_.point(b) - from_.point(a); };
    return dot(along(from_.origin(e), from_.destination(e)), along(s.a, s.b)) >= 0;
  }

  // The segments in the order of the input, and in new_id_ where each piece went.
  std::vector<Segment> in_input_order(const std::vector<Piece>& pieces) {
    std::vector<std::size_t> order(pieces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return pieces[i].of; });
    std::vector<Segment> segments;
    new_id_.resize(pieces.size());
    for (const std::size_t i : order) {
      new_id_[i] = SegmentId(segments.size());
      segments.push_back(pieces[i].segment);
    }
    of_input_ = segments.size();
    add_open_sides(segments);
    return segments;
  }

  VertexId new_vertex(VertexId old) const { return *vertex_[old.index()]; }

  std::pair<double, double> parameters(HalfEdge e) const {
    const ConstrainedEdge& record = from_.constrained_edge(e);
    if (from_.origin(e) < from_.destination(e)) return {record.t_low, record.t_high};
    return {record.t_high, record.t_low};
  }

  // Boundary edges that no segment asked for: the sides of a convex hull.
  void add_open_sides(std::vector<Segment>& segments) {
    for (std::size_t t = 0; t < from_.triangle_count(); ++t) {
      if (!kept(TriangleId(t))) continue;
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge old{TriangleId(t), i}, e{*triangle_[t], i};
        if (!to_.is_boundary(e) || from_.is_constrained(old)) continue;
        segments.push_back({to_.origin(e), to_.destination(e), {}, 0, 1});
        open_sides_.push_back(e);
      }
    }
  }

  void own_edges() {
    std::size_t next = 0;  // pieces come up in the order in which copy_segments() saw them
    for_each_constrained_edge([&](HalfEdge old) {
      if (!kept(old)) return;
      const auto across = from_.twin(old);
      const HalfEdge side = kept(old.triangle) ? old : *across;
      const HalfEdge e{*triangle_[side.triangle.index()], side.edge};
      const auto [t_a, t_b] = parameters(side);
      for (std::size_t k = from_.segments_of(old).size(); k > 0; --k) {
        to_.add_owner(e, new_id_[next++], t_a, t_b);
      }
    });
    for (std::size_t i = 0; i < open_sides_.size(); ++i) {
      to_.add_owner(open_sides_[i], SegmentId(of_input_ + i), 0, 1);
    }
  }

  void keep_point_entities() {
    std::vector<PointEntity> inside;
    for (PointEntity point : from_.entities().points) {
      const auto& vertex = vertex_[point.vertex.index()];
      if (!vertex) continue;
      point.vertex = *vertex;
      inside.push_back(std::move(point));
    }
    Entities entities = from_.entities();
    entities.points = std::move(inside);
    to_.set_entities(std::move(entities));
  }

  const Mesh& from_;
  const std::vector<std::optional<SurfaceId>>& regions_;
  TriangulationReport& report_;
  Mesh to_;
  std::vector<std::optional<VertexId>> vertex_;
  std::vector<std::optional<TriangleId>> triangle_;
  std::vector<SegmentId> new_id_;
  std::size_t of_input_ = 0;
  std::vector<HalfEdge> open_sides_;
};

}  // namespace

Mesh extract_regions(const Mesh& mesh, const std::vector<std::optional<SurfaceId>>& regions,
                     TriangulationReport& report) {
  return Extractor(mesh, regions, report).run();
}

}  // namespace lepp::plain
