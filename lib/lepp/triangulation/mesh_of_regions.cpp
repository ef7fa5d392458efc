#include "lepp/triangulation/mesh_of_regions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lepp/geometry/two_threads.hpp"

namespace lepp {

namespace {

using Code = RawTriangulation::Code;
constexpr std::uint32_t unused = 0xFFFFFFFFU;

class MeshOfRegions {
 public:
  MeshOfRegions(RawTriangulation& raw, Regions& regions, const Pslg& pslg,
                std::vector<VertexId>& vertex_of, TriangulationReport& report)
      : raw_(raw), regions_(regions), pslg_(pslg), vertex_of_(vertex_of), report_(report) {}

  // In an order that lets go of each array before the next one is made.
  Mesh run(SegmentPieces& pieces, unsigned threads) {
    mesh_.set_source(pslg_.source, pslg_.base);
    mark_vertices();
    drop_outside(pieces);
    raw_.points = {};
    number_vertices();
    TriangleArray triangles;
    in_parallel(
        threads, [&] { triangles = raw_.take_triangles(regions_.of_label, vertex_); },
        [&] {
          add_vertices();
          if (!report_.convex_hull) set_segments(pieces, {});
        });
    mesh_.adopt(std::move(triangles), raw_.leaving, vertex_);
    raw_.leaving = {};
    if (report_.convex_hull) set_segments(pieces, open_sides());
    vertex_ = {};
    set_entities();
    return std::move(mesh_);
  }

 private:
  bool is_kept(std::uint32_t t) const { return regions_.of_label[raw_.label(t)].has_value(); }

  // vertex_: anything but `unused` for each vertex of a kept triangle, for now. border_: vertices
  // with a constrained edge that has nothing kept on either side.
  void mark_vertices() {
    vertex_.assign(raw_.points.size(), unused);
    border_.assign(raw_.points.size(), false);
    for (std::uint32_t t = 0; t < raw_.triangles.size(); ++t) {
      if (is_kept(t)) {
        for (const VertexId v : raw_.triangles[t].vertices) vertex_[v.index()] = 0;
        continue;
      }
      for (std::uint32_t i = 0; i < 3; ++i) {
        const Code e = RawTriangulation::code(t, i);
        if (!raw_.is_constrained(e)) continue;
        if (is_kept(RawTriangulation::triangle_of(raw_.twin(e)))) continue;
        border_[raw_.origin(e).index()] = border_[raw_.destination(e).index()] = true;
      }
    }
  }

  bool is_inside(const SegmentPiece& piece) const {
    if (vertex_[piece.a.index()] == unused || vertex_[piece.b.index()] == unused) return false;
    if (!border_[piece.a.index()] || !border_[piece.b.index()]) return true;
    const Code e = raw_.edge_between(piece.a, piece.b);
    return is_kept(RawTriangulation::triangle_of(e)) ||
           is_kept(RawTriangulation::triangle_of(raw_.twin(e)));
  }

  // Pieces outside the domain go; each segment that loses one is counted once.
  void drop_outside(SegmentPieces& pieces) {
    std::vector<std::int64_t> losers;  // the numbers of the user, whose segments may be cut already
    for (auto* list : {&pieces.first, &pieces.further}) {
      std::erase_if(*list, [&](const SegmentPiece& piece) {
        if (is_inside(piece)) return false;
        losers.push_back(pslg_.segment_number(piece.segment));
        return true;
      });
    }
    std::ranges::sort(losers);
    losers.erase(std::unique(losers.begin(), losers.end()), losers.end());
    report_.segments_outside = losers.size();
  }

  // In input order; a point with an earlier copy shares its vertex.
  void number_vertices() {
    report_.vertex_of_point.resize(vertex_of_.size());
    const bool has_copies = report_.duplicate_points > 0;
    for (std::uint32_t i = 0; i < vertex_of_.size(); ++i) {
      const std::size_t v = vertex_of_[i].index();
      if (vertex_[v] == unused) continue;
      if (!has_copies || raw_.input[v] == i) vertex_[v] = vertices_++;
      report_.vertex_of_point[i] = VertexId(vertex_[v]);
    }
    report_.points_outside = vertex_.size() - vertices_;
    vertex_of_ = {};
    raw_.input = {};
  }

  void add_vertices() {
    mesh_.reserve(vertices_, 0);
    for (std::uint32_t i = 0; i < report_.vertex_of_point.size(); ++i) {
      const auto v = report_.vertex_of_point[i];
      if (!v || v->index() != mesh_.vertex_count()) continue;  // outside, or a copy
      mesh_.add_vertex(pslg_.points[i], {VertexOrigin::Kind::input, i});
    }
  }

  // Where vertex v of the mesh lies on the curve of segment s.
  double parameter(const Segment& s, VertexId v) const {
    if (v == report_.vertex_of_point[s.a.index()]) return s.t_a;
    if (v == report_.vertex_of_point[s.b.index()]) return s.t_b;
    const Point a = pslg_.points[s.a.index()], b = pslg_.points[s.b.index()], p = mesh_.point(v);
    const double along = std::sqrt(squared_distance(a, p) / squared_distance(a, b));
    return s.t_a + along * (s.t_b - s.t_a);
  }

  VertexId in_mesh(VertexId v) const { return VertexId(vertex_[v.index()]); }

  Segment segment_of(const SegmentPiece& piece) const {
    const Segment& whole = pslg_.segments[piece.segment.index()];
    const VertexId a = in_mesh(piece.a), b = in_mesh(piece.b);
    return {a, b, whole.curve, parameter(whole, a), parameter(whole, b)};
  }

  // One per piece and, where the mesh ends at the convex hull, one per side that is no piece.
  void set_segments(SegmentPieces& pieces, const std::vector<HalfEdge>& open) {
    auto& first = pieces.first;
    auto& further = pieces.further;
    std::vector<Segment> segments;
    segments.reserve(first.size() + further.size() + open.size());
    std::vector<SegmentId> owners_again;  // of edges that have an owner already
    for (std::size_t i = 0, j = 0; i < first.size() || j < further.size();) {
      const bool again =
          i == first.size() || (j < further.size() && further[j].segment < first[i].segment);
      if (again) owners_again.push_back(SegmentId(segments.size()));
      segments.push_back(segment_of(again ? further[j++] : first[i++]));
    }
    for (const HalfEdge e : open) {
      segments.push_back({mesh_.origin(e), mesh_.destination(e), {}, 0, 1});
    }
    first = {};
    mesh_.set_segments(std::move(segments));
    mesh_.own_edges(owners_again);
    for (const HalfEdge e : open) mesh_.set_constrained_flag(e, true);
  }

  // Boundary edges that no segment asked for: the sides of a convex hull.
  std::vector<HalfEdge> open_sides() const {
    std::vector<HalfEdge> sides;
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge e{TriangleId(t), i};
        if (mesh_.is_boundary(e) && !mesh_.is_constrained(e)) sides.push_back(e);
      }
    }
    return sides;
  }

  void set_entities() {
    Entities entities = std::move(regions_.entities);
    std::vector<PointEntity> inside;
    for (PointEntity& point : entities.points) {
      const auto vertex = report_.vertex_of_point[point.vertex.index()];
      if (!vertex) continue;
      point.vertex = *vertex;
      inside.push_back(std::move(point));
    }
    entities.points = std::move(inside);
    mesh_.set_entities(std::move(entities));
  }

  RawTriangulation& raw_;
  Regions& regions_;
  const Pslg& pslg_;
  std::vector<VertexId>& vertex_of_;
  TriangulationReport& report_;
  Mesh mesh_;
  std::vector<std::uint32_t> vertex_;  // of the mesh, for each vertex of raw_
  std::vector<bool> border_;
  std::uint32_t vertices_ = 0;  // of the mesh
};

}  // namespace

Mesh mesh_of_regions(RawTriangulation raw, Regions regions, const Pslg& pslg, SegmentPieces pieces,
                     std::vector<VertexId> vertex_of, TriangulationReport& report,
                     unsigned threads) {
  return MeshOfRegions(raw, regions, pslg, vertex_of, report).run(pieces, threads);
}

}  // namespace lepp
