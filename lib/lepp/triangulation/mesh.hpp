#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "lepp/geometry/entities.hpp"
#include "lepp/geometry/growing_array.hpp"
#include "lepp/geometry/ids.hpp"
#include "lepp/geometry/memory_access.hpp"
#include "lepp/geometry/point.hpp"
#include "lepp/geometry/pslg.hpp"
#include "lepp/triangulation/edge_records.hpp"

namespace lepp {

/// One side of an edge: edge `edge` of `triangle` lies opposite corner `edge` and runs from
/// corner edge+1 to corner edge+2 (mod 3), the triangle on its left.
struct HalfEdge {
  TriangleId triangle;
  std::uint32_t edge = 0;
  friend constexpr auto operator<=>(HalfEdge, HalfEdge) = default;
};

constexpr std::uint32_t next_corner(std::uint32_t i) { return i == 2 ? 0 : i + 1; }
constexpr std::uint32_t previous_corner(std::uint32_t i) { return i == 0 ? 2 : i - 1; }
constexpr HalfEdge next_edge(HalfEdge e) { return {e.triangle, next_corner(e.edge)}; }
constexpr HalfEdge previous_edge(HalfEdge e) { return {e.triangle, previous_corner(e.edge)}; }

/// 32 bytes: three corners counter-clockwise, what lies across each edge, the region, and a flag
/// per edge. Only Mesh, and the kernel that builds one, write it.
class Triangle {
 public:
  std::array<VertexId, 3> vertices;

  SurfaceId region() const { return region_; }

 private:
  friend class Mesh;
  friend class RawTriangulation;  // raw_triangulation.hpp
  static constexpr std::uint32_t nothing = 0xFFFFFFFFU;
  std::array<std::uint32_t, 3> across_;  // 4 * triangle + edge of the other side, or nothing
  SurfaceId region_;
  std::uint32_t constrained_ = 0;  // bit i: edge i is constrained
};
static_assert(sizeof(Triangle) == 32);
using TriangleArray = GrowingArray<Triangle>;

/// 4 * triangle + edge and "nothing" share 32 bits.
inline constexpr std::size_t max_triangles = (std::size_t{1} << 30) - 1;

/// Where a vertex comes from.
struct VertexOrigin {
  enum class Kind : std::uint32_t {
    input,       ///< point `index` of the PSLG; from its size on, crossings of its segments
    on_segment,  ///< a Steiner point on a constrained edge; `index` is its SegmentSetId
    interior,    ///< a Steiner point inside a region
  };
  Kind kind = Kind::interior;
  std::uint32_t index = 0;
};

/// What the side table keeps about a constrained edge.
struct ConstrainedEdge {
  SegmentSetId segments;  ///< the input segments that own it
  double t_low = 0;       ///< curve parameter at the end with the smaller VertexId
  double t_high = 1;      ///< and at the other end
};

/// A conforming triangulation with regions and constrained edges; the one data structure every
/// stage works on. Between stages it satisfies M1 to M6 (validate.hpp).
///
/// Vertices of the input come first, in input order; Steiner points follow in order of insertion.
/// A vertex may be shared by several fans of triangles (two holes that touch).
/// Copying is deep; nothing is shared or global.
class Mesh {
 public:
  // ---- sizes and arrays: contiguous, never copied -------------------------------------------
  std::size_t vertex_count() const { return points_.size(); }
  std::size_t triangle_count() const { return triangles_.size(); }
  std::span<const Point> points() const { return points_; }
  std::span<const Triangle> triangles() const { return triangles_; }
  std::span<const VertexOrigin> origins() const { return origins_; }
  /// The input segments, cut at input points on them and at crossings; then the sides of the mesh
  /// that no input segment asked for.
  std::span<const Segment> segments() const { return segments_; }
  const Entities& entities() const { return entities_; }
  /// What messages call the input, and the number of its first point there.
  const std::string& source() const { return source_; }
  std::int64_t base() const { return base_; }

  // ---- asking --------------------------------------------------------------------------------
  Point point(VertexId v) const { return points_[v.index()]; }
  const std::array<VertexId, 3>& vertices(TriangleId t) const {
    return triangles_[t.index()].vertices;
  }
  VertexId vertex(TriangleId t, std::uint32_t corner) const { return vertices(t)[corner]; }
  std::array<Point, 3> corners(TriangleId t) const {
    const auto& [a, b, c] = vertices(t);
    return {point(a), point(b), point(c)};
  }
  SurfaceId region(TriangleId t) const { return triangles_[t.index()].region_; }
  const VertexOrigin& origin_of(VertexId v) const { return origins_[v.index()]; }
  bool is_input(VertexId v) const { return origin_of(v).kind == VertexOrigin::Kind::input; }

  VertexId origin(HalfEdge e) const { return vertex(e.triangle, next_corner(e.edge)); }
  VertexId destination(HalfEdge e) const { return vertex(e.triangle, previous_corner(e.edge)); }
  VertexId apex(HalfEdge e) const { return vertex(e.triangle, e.edge); }

  /// The same edge seen from the other side; nothing across the boundary of the mesh.
  std::optional<HalfEdge> twin(HalfEdge e) const {
    const std::uint32_t across = triangles_[e.triangle.index()].across_[e.edge];
    if (across == nothing) return std::nullopt;
    return half_edge(across);
  }
  bool is_boundary(HalfEdge e) const {
    return triangles_[e.triangle.index()].across_[e.edge] == nothing;
  }
  bool is_constrained(HalfEdge e) const {
    return (triangles_[e.triangle.index()].constrained_ >> e.edge & 1U) != 0;
  }
  /// An edge with another region, or no mesh, on its other side.
  bool separates_regions(HalfEdge e) const {
    const auto across = twin(e);
    return !across || region(across->triangle) != region(e.triangle);
  }
  /// The record of a constrained edge. \pre is_constrained(e)
  ConstrainedEdge constrained_edge(HalfEdge e) const;
  /// The input segments that own a constrained edge, at least one.
  std::span<const SegmentId> segments_of(HalfEdge e) const;
  std::span<const SegmentId> segments_of(SegmentSetId set) const;
  /// The curve that a constrained edge is a piece of, if it is a piece of exactly one.
  std::optional<CurveId> curve_of(HalfEdge e) const;
  /// A half-edge that leaves `v`: one fan of `v` is reached by turning around it. If that fan is
  /// open, the half-edge is its boundary edge, from where turning counter-clockwise sees it all.
  HalfEdge leaving(VertexId v) const { return half_edge(leaving_[v.index()]); }
  /// The half-edge from a to b, if triangles of the fan of leaving(a) have it. O(degree).
  std::optional<HalfEdge> find_edge(VertexId a, VertexId b) const;

  /// Asks the memory for what will be looked at soon: a triangle, or the point of a vertex.
  void prefetch(TriangleId t) const { lepp::prefetch(triangles_.data() + t.index()); }
  void prefetch(VertexId v) const { lepp::prefetch(points_.data() + v.index()); }
  void prefetch_leaving(VertexId v) const { lepp::prefetch(leaving_.data() + v.index()); }

  // ---- building and changing: for the triangulation layer ------------------------------------
  // These keep each array consistent in itself; M1 to M6 are the caller's to restore.
  void set_source(std::string source, std::int64_t base);
  void set_entities(Entities entities) { entities_ = std::move(entities); }
  Entities& mutable_entities() { return entities_; }
  void set_segments(std::vector<Segment> segments);
  void reserve(std::size_t vertices, std::size_t triangles);
  /// Takes over all triangles at once, linked and flagged already. `leaving[i]` is the code of a
  /// half-edge that leaves vertex number `vertex[i]`, the boundary edge if it has one; or nothing.
  void adopt(TriangleArray triangles, std::span<const std::uint32_t> leaving,
             std::span<const std::uint32_t> vertex);
  /// Gives the edge between the ends of each segment to that segment. The flags are set already.
  /// \param again  ascending: segments whose edge has an owner with a smaller id
  /// Cost  O(segments + s log s) for s segments in `again`; one set for each shared edge
  void own_edges(std::span<const SegmentId> again);
  /// Vertex v becomes vertex `number_of[v]`, triangle t triangle `number_of[t]`, wherever the mesh
  /// refers to them. \pre permutations; the first keeps the input vertices first.  O(n)
  void renumber_vertices(std::span<const std::uint32_t> number_of);
  void renumber_triangles(std::span<const std::uint32_t> number_of);
  VertexId add_vertex(Point p, VertexOrigin origin);
  void move_vertex(VertexId v, Point p) { points_[v.index()] = p; }
  TriangleId add_triangle(VertexId a, VertexId b, VertexId c, SurfaceId region);
  /// Gives `t` new corners; edges keep their links and flags until link() changes them.
  /// Call refresh_leaving() for the triangles that took over corners of `t`, once all are set.
  void set_vertices(TriangleId t, VertexId a, VertexId b, VertexId c);
  /// The same without the repair of leaving(v).
  void replace_vertices(TriangleId t, VertexId a, VertexId b, VertexId c) {
    triangles_[t.index()].vertices = {a, b, c};
  }
  /// Makes `e` leaving(origin(e)) if what is there starts elsewhere now.
  void refresh_leaving(HalfEdge e);
  /// Repairs leaving(v) for corners of `t` whose half-edge no longer starts at them.
  void refresh_leaving(TriangleId t);
  /// Removes `t`, which no link and no leaving() refers to: the last triangle takes its id.
  /// \return the id that this triangle had, unless it was `t` itself.  O(1)
  std::optional<TriangleId> remove_triangle(TriangleId t);
  /// Removes `v`, which no triangle and no record refers to: the last vertex takes its id, also in
  /// the records of its constrained edges. \pre the last vertex has one fan and is not of the input
  /// \return the id that this vertex had, unless it was `v` itself.  O(degree)
  std::optional<VertexId> remove_vertex(VertexId v);
  void set_region(TriangleId t, SurfaceId region) { triangles_[t.index()].region_ = region; }
  /// Makes `e` and `f` the two sides of one edge.
  void link(HalfEdge e, HalfEdge f);
  /// Makes `e` a boundary edge, and leaving(origin(e)).
  void unlink(HalfEdge e);
  /// Links `e` to what lies across `old`, which may be nothing, and copies the constrained flag.
  void take_place_of(HalfEdge e, HalfEdge old);
  void set_constrained_flag(HalfEdge e, bool constrained);
  /// Flags both sides of `e` and stores its record.
  void constrain(HalfEdge e, const ConstrainedEdge& record);
  /// Adds a segment to the owners of an edge, which becomes constrained if it was not. Each call
  /// on a shared edge makes a set of its own: own_edges() is the way to give an edge many owners.
  void add_owner(HalfEdge e, SegmentId s, double t_origin, double t_destination);
  /// The record of edge (a, b), whether or not a triangle has that edge now.
  std::optional<ConstrainedEdge> find_record(VertexId a, VertexId b) const;
  void set_record(VertexId a, VertexId b, const ConstrainedEdge& record);
  void erase_record(VertexId a, VertexId b);
  /// The record of edge (a, b) goes over to (a, v) and (v, b), `t` the curve parameter of `v`.
  void split_record(VertexId a, VertexId b, VertexId v, double t);
  /// The records of (a, v) and (v, b), of one segment, become that of (a, b) again.
  void join_records(VertexId a, VertexId v, VertexId b);
  /// The next so many of split_record(), and any of join_records() and remove_vertex(), then cannot
  /// fail. \throw std::bad_alloc; nothing has changed then
  void make_room_for_records(std::size_t splits) { constrained_edges_.make_room_for(splits); }

  // For two threads that change different triangles: each call writes one side of an edge, one
  // triangle or one vertex only.
  /// Adds so many vertices and triangles, which the next functions then set.
  /// \throw RefusedError beyond max_triangles, std::bad_alloc; nothing has changed then
  void grow(std::size_t vertices, std::size_t triangles);
  void set_vertex(VertexId v, Point p, VertexOrigin origin) {
    points_[v.index()] = p;
    origins_[v.index()] = origin;
  }
  void set_leaving(VertexId v, HalfEdge e) { leaving_[v.index()] = code(e); }
  /// leaving(v) becomes `to` if it is `from`. Calls for one `v` at a time need different `from`.
  void move_leaving(VertexId v, HalfEdge from, HalfEdge to) {
    std::uint32_t& leaving = leaving_[v.index()];
    if (load_relaxed(leaving) == code(from)) store_relaxed(leaving, code(to));
  }
  /// A triangle without constrained edges and with nothing across them yet.
  void set_triangle(TriangleId t, const std::array<VertexId, 3>& vertices, SurfaceId region) {
    Triangle& triangle = triangles_[t.index()];
    triangle.vertices = vertices;
    triangle.across_ = {nothing, nothing, nothing};
    triangle.region_ = region;
    triangle.constrained_ = 0;
  }
  void set_across(HalfEdge e, std::optional<HalfEdge> across) {
    triangles_[e.triangle.index()].across_[e.edge] = across ? code(*across) : nothing;
  }

 private:
  friend class RawTriangulation;
  static constexpr std::uint32_t nothing = Triangle::nothing;
  static std::uint32_t code(HalfEdge e) { return 4 * e.triangle.value + e.edge; }
  static HalfEdge half_edge(std::uint32_t code) { return {TriangleId(code / 4), code % 4}; }

  [[noreturn]] void refuse_more_triangles() const;
  void move_record(VertexId end, VertexId from, VertexId to);
  void share_edge(VertexId a, VertexId b, std::vector<SegmentId> owners);

  GrowingArray<Point> points_;
  GrowingArray<VertexOrigin> origins_;
  GrowingArray<std::uint32_t> leaving_;  // code of a half-edge that starts at the vertex
  TriangleArray triangles_;
  EdgeRecords constrained_edges_;
  std::vector<Segment> segments_;
  std::vector<std::vector<SegmentId>> shared_sets_;  // sets of two and more segments
  std::map<std::vector<SegmentId>, SegmentSetId> shared_set_index_;
  std::vector<SegmentId> own_set_;  // set i holds segment i, for all segments
  Entities entities_;
  std::string source_;
  std::int64_t base_ = 0;
};

// The innermost steps of every local operation.

inline void Mesh::set_vertices(TriangleId t, VertexId a, VertexId b, VertexId c) {
  replace_vertices(t, a, b, c);
  refresh_leaving(t);
}

inline void Mesh::refresh_leaving(HalfEdge e) {
  const VertexId v = origin(e);
  std::uint32_t& leaving = leaving_[v.index()];
  if (leaving == nothing || origin(half_edge(leaving)) != v) leaving = code(e);
}

inline void Mesh::refresh_leaving(TriangleId t) {
  for (std::uint32_t i = 0; i < 3; ++i) refresh_leaving({t, i});
}

inline void Mesh::unlink(HalfEdge e) {
  triangles_[e.triangle.index()].across_[e.edge] = nothing;
  leaving_[origin(e).index()] = code(e);
}

inline void Mesh::link(HalfEdge e, HalfEdge f) {
  triangles_[e.triangle.index()].across_[e.edge] = code(f);
  triangles_[f.triangle.index()].across_[f.edge] = code(e);
}

inline void Mesh::set_constrained_flag(HalfEdge e, bool constrained) {
  std::uint32_t& flags = triangles_[e.triangle.index()].constrained_;
  const std::uint32_t bit = 1U << e.edge;
  flags = constrained ? flags | bit : flags & ~bit;
}

/// Calls visit(TriangleId, corner) for each triangle of the fan of leaving(v), once each, turning
/// counter-clockwise from the boundary if the fan is open, else from leaving(v).
/// visit may return void, or bool: false stops the walk.
template <class Visit>
void for_each_in_fan(const Mesh& mesh, VertexId v, Visit visit);

}  // namespace lepp

#include "lepp/triangulation/mesh_fan.hpp"
