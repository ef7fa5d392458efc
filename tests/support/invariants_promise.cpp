#include <algorithm>

#include "lepp/geometry/text.hpp"
#include "support/invariants.hpp"
#include "support/mesh_edges.hpp"
#include "support/oracle.hpp"

namespace lepp::test {

namespace {

using Broken = std::optional<std::string>;

class PromiseCheck {
 public:
  PromiseCheck(const Mesh& mesh, const TriangulationReport& report, const Pslg& pslg,
               const Arrangement& arrangement)
      : mesh_(mesh), report_(report), pslg_(pslg), arrangement_(arrangement), edges_(mesh) {}

  Broken run() {
    if (Broken broken = broken_vertices()) return broken;
    if (Broken broken = broken_pieces()) return broken;
    if (Broken broken = broken_extra_constraints()) return broken;
    if (Broken broken = broken_hull()) return broken;
    if (Broken broken = broken_faces()) return broken;
    return broken_seeds();
  }

 private:
  std::string place(std::uint32_t point) const { return to_text(arrangement_.points[point]); }

  // Also fills vertex_of_ and point_of_, between points of the arrangement and vertices.
  Broken broken_vertices() {
    vertex_of_.resize(arrangement_.points.size());
    point_of_.resize(mesh_.vertex_count());
    std::int64_t before = -1;
    for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
      const VertexOrigin origin = mesh_.origin_of(VertexId(v));
      const bool input = origin.kind == VertexOrigin::Kind::input;
      if (!input || origin.index >= pslg_.points.size()) return "a vertex is no input point";
      if (pslg_.points[origin.index] != mesh_.point(VertexId(v))) return "an input point moved";
      if (origin.index <= before) return "vertices are not in the order of the input";
      before = origin.index;
      point_of_[v] = arrangement_.point_of[origin.index];
      vertex_of_[point_of_[v]] = VertexId(v);
    }
    for (std::size_t i = 0; i < pslg_.points.size(); ++i) {
      if (report_.vertex_of_point.at(i) != vertex_of_[arrangement_.point_of[i]]) {
        return "vertex_of_point is wrong for point " + std::to_string(i);
      }
    }
    return std::nullopt;
  }

  std::optional<HalfEdge> edge_between(std::uint32_t a, std::uint32_t b) const {
    if (!vertex_of_[a] || !vertex_of_[b]) return std::nullopt;
    const auto e = edges_.find(*vertex_of_[a], *vertex_of_[b]);
    return e ? e : edges_.find(*vertex_of_[b], *vertex_of_[a]);
  }

  Broken broken_pieces() {
    for (std::size_t s = 0; s < arrangement_.chains.size(); ++s) {
      const auto& chain = arrangement_.chains[s];
      for (std::size_t i = 1; i < chain.size(); ++i) {
        const auto e = edge_between(chain[i - 1], chain[i]);
        const std::string piece = place(chain[i - 1]) + " - " + place(chain[i]);
        if (!e) {
          if (enters_mesh(chain[i - 1], chain[i]) || enters_mesh(chain[i], chain[i - 1])) {
            return "the mesh misses the piece " + piece;
          }
          continue;
        }
        if (!mesh_.is_constrained(*e)) return "the piece is not constrained: " + piece;
        if (!is_owned_by(*e, pslg_.segments[s].curve)) return "the curve was lost: " + piece;
      }
    }
    return std::nullopt;
  }

  bool is_owned_by(HalfEdge e, std::optional<CurveId> curve) const {
    const auto owners = mesh_.segments_of(e);
    return std::any_of(owners.begin(), owners.end(),
                       [&](SegmentId s) { return mesh_.segments()[s.index()].curve == curve; });
  }

  // True if, close to a, the way from a to b runs inside a triangle or along an edge.
  bool enters_mesh(std::uint32_t a, std::uint32_t b) const {
    if (!vertex_of_[a]) return false;
    const Point p = arrangement_.points[a], q = arrangement_.points[b];
    const auto leaving = edges_.leaving(*vertex_of_[a]);
    return std::any_of(leaving.begin(), leaving.end(), [&](HalfEdge e) {
      const Point u = mesh_.point(mesh_.destination(e)), w = mesh_.point(mesh_.apex(e));
      const int from_u = oracle_orient2d(p, u, q), from_w = oracle_orient2d(p, q, w);
      if (from_u == 0 && oracle_dot_sign(u, p, q) > 0) return true;
      if (from_w == 0 && oracle_dot_sign(w, p, q) > 0) return true;
      return from_u > 0 && from_w > 0;
    });
  }

  // A constrained edge is a piece, or a side of the hull where the pieces close no face.
  Broken broken_extra_constraints() {
    const bool is_hull = arrangement_.closed_faces() == 0;
    if (report_.convex_hull != is_hull) return "convex_hull is wrong";
    if (is_hull) find_open_sides();
    for (const SortedEdges::Entry& entry : edges_.entries()) {
      const HalfEdge e = entry.edge;
      if (!mesh_.is_constrained(e)) continue;
      const auto [a, b] = points_of(e);
      const Arrangement::Piece piece = std::minmax(a, b);
      if (arrangement_.has_piece(a, b)) continue;
      if (!std::binary_search(open_sides_.begin(), open_sides_.end(), piece)) {
        return "no segment runs along the constrained " + place(a) + " - " + place(b);
      }
    }
    return std::nullopt;
  }

  std::pair<std::uint32_t, std::uint32_t> points_of(HalfEdge e) const {
    return {point_of_[mesh_.origin(e).index()], point_of_[mesh_.destination(e).index()]};
  }

  // The sides of the hull that no segment asked for.
  void find_open_sides() {
    const std::vector<std::uint32_t> hull = arrangement_.hull();
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const std::uint32_t a = hull[i], b = hull[(i + 1) % hull.size()];
      if (!arrangement_.has_piece(a, b)) open_sides_.emplace_back(std::minmax(a, b));
    }
    std::sort(open_sides_.begin(), open_sides_.end());
  }

  // A domain without closed faces and holes is the convex hull: all points, its sides the boundary.
  Broken broken_hull() const {
    if (!report_.convex_hull || !pslg_.holes.empty()) return std::nullopt;
    if (mesh_.vertex_count() != arrangement_.points.size()) return "the hull lost a point";
    const std::vector<std::uint32_t> hull = arrangement_.hull();
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const std::uint32_t a = hull[i], b = hull[(i + 1) % hull.size()];
      const auto e = edges_.find(*vertex_of_[a], *vertex_of_[b]);
      if (!e || !mesh_.is_boundary(*e)) return "no boundary edge " + place(a) + " - " + place(b);
    }
    const auto is_boundary = [&](const SortedEdges::Entry& e) { return mesh_.is_boundary(e.edge); };
    const auto sides = std::count_if(edges_.entries().begin(), edges_.entries().end(), is_boundary);
    if (sides != static_cast<std::ptrdiff_t>(hull.size())) return "the hull has a gap";
    return std::nullopt;
  }

  Broken broken_faces() {
    const std::size_t faces = parts_of(mesh_, JoinAcross::unconstrained_edges).count;
    const std::size_t closed = arrangement_.closed_faces(open_sides_);
    if (faces > closed || faces + pslg_.holes.size() < closed) {
      return std::to_string(faces) + " faces of " + std::to_string(closed) + " are left, for " +
             std::to_string(pslg_.holes.size()) + " holes";
    }
    for (const Point hole : pslg_.holes) {
      if (lies_on_segment(hole)) return "the hole " + to_text(hole) + " lies on a segment, unseen";
      if (!triangles_at(hole).empty()) return "the hole " + to_text(hole) + " is filled";
    }
    return std::nullopt;
  }

  std::vector<TriangleId> triangles_at(Point p) const {
    std::vector<TriangleId> found;
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      const auto [a, b, c] = mesh_.corners(TriangleId(t));
      if (oracle_orient2d(a, b, p) >= 0 && oracle_orient2d(b, c, p) >= 0 &&
          oracle_orient2d(c, a, p) >= 0) {
        found.emplace_back(t);
      }
    }
    return found;
  }

  bool lies_on_segment(Point p) const {
    for (const TriangleId t : triangles_at(p)) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge e{t, i};
        const Point a = mesh_.point(mesh_.origin(e)), b = mesh_.point(mesh_.destination(e));
        const bool asked = !report_.convex_hull || !mesh_.is_boundary(e);
        if (asked && mesh_.is_constrained(e) && oracle_orient2d(a, b, p) == 0) return true;
      }
    }
    return false;
  }

  // The first seed in a face names its region; a face without one gets a surface that no seed has.
  Broken broken_seeds() {
    const Parts faces = parts_of(mesh_, JoinAcross::unconstrained_edges);
    std::vector<std::optional<SurfaceId>> wanted(faces.count);
    for (const RegionSeed& seed : pslg_.seeds) {
      const auto found = triangles_at(seed.at);
      if (found.empty()) continue;
      if (lies_on_segment(seed.at)) {
        return "the seed " + to_text(seed.at) + " lies on a segment, unseen";
      }
      auto& region = wanted[faces.of_triangle[found.front().index()]];
      if (!region) region = seed.surface;
    }
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      const SurfaceId region = mesh_.region(TriangleId(t));
      if (region.index() >= mesh_.entities().surfaces.size()) return "a region is not there";
      const auto& face = wanted[faces.of_triangle[t]];
      if (face ? region != *face : region.index() < pslg_.entities.surfaces.size()) {
        return "triangle " + std::to_string(t) + " is in the wrong region";
      }
    }
    return std::nullopt;
  }

  const Mesh& mesh_;
  const TriangulationReport& report_;
  const Pslg& pslg_;
  const Arrangement& arrangement_;
  SortedEdges edges_;
  std::vector<std::optional<VertexId>> vertex_of_;
  std::vector<std::uint32_t> point_of_;
  std::vector<Arrangement::Piece> open_sides_;
};

}  // namespace

std::optional<std::string> broken_promise(const Mesh& mesh, const TriangulationReport& report,
                                          const Pslg& pslg, const Arrangement& arrangement) {
  return PromiseCheck(mesh, report, pslg, arrangement).run();
}

}  // namespace lepp::test
