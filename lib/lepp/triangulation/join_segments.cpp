#include "lepp/triangulation/join_segments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "lepp/geometry/triangle_measures.hpp"

namespace lepp {

namespace {

// Points put on a segment one after the other are off it by the sum of their roundings, half an
// ulp each: after all halvings of a double fewer than 32 ulp of the largest coordinate.
constexpr double most_ulps = 32;

class Joiner {
 public:
  explicit Joiner(Mesh& mesh) : mesh_(mesh), edges_at_(mesh.vertex_count()) {
    double largest = 0;
    for (const Point p : mesh.points()) {
      largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    }
    tolerance_ = most_ulps * 0x1p-52 * largest;
  }

  void run() {
    collect_edges();
    std::vector<Part> parts;
    std::vector<Segment> segments;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (!edges_[i].joined) add_chain(i, parts, segments);
    }
    for (const Edge& edge : edges_) mesh_.erase_record(edge.a, edge.b);
    mesh_.set_segments(std::move(segments));
    for (const Part& part : parts) mesh_.add_owner(part.e, part.segment, part.t_a, part.t_b);
  }

 private:
  struct Edge {
    HalfEdge e;
    VertexId a, b;
    std::vector<std::optional<CurveId>> curves;  // of its owners, ascending
    bool joined = false;
  };
  // The edges that end at a vertex, if they are at most two.
  struct EdgesAt {
    std::array<std::uint32_t, 2> edge{};
    std::uint32_t count = 0;
  };
  struct Part {
    HalfEdge e;
    SegmentId segment;
    double t_a, t_b;
  };

  void collect_edges() {
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const HalfEdge e{TriangleId(t), k};
        const auto across = mesh_.twin(e);
        if (!mesh_.is_constrained(e) || (across && *across < e)) continue;
        Edge edge{e, mesh_.origin(e), mesh_.destination(e), {}};
        for (const SegmentId s : mesh_.segments_of(e)) {
          edge.curves.push_back(mesh_.segments()[s.index()].curve);
        }
        std::ranges::sort(edge.curves);
        note_end(edge.a);
        note_end(edge.b);
        edges_.push_back(std::move(edge));
      }
    }
  }

  void note_end(VertexId v) {
    EdgesAt& at = edges_at_[v.index()];
    if (at.count < 2) at.edge[at.count] = static_cast<std::uint32_t>(edges_.size());
    ++at.count;
  }

  VertexId other_end(std::size_t edge, VertexId v) const {
    return edges_[edge].a == v ? edges_[edge].b : edges_[edge].a;
  }

  // The edge that carries on beyond the end v of `edge`.
  std::optional<std::size_t> next(std::size_t edge, VertexId v) const {
    const EdgesAt& at = edges_at_[v.index()];
    if (at.count != 2) return std::nullopt;
    const std::size_t other = at.edge[0] == edge ? at.edge[1] : at.edge[0];
    if (edges_[other].curves != edges_[edge].curves) return std::nullopt;
    const Point p = mesh_.point(other_end(edge, v)), q = mesh_.point(other_end(other, v));
    const Point at_v = mesh_.point(v);
    if (dot(p - at_v, q - at_v) >= 0) return std::nullopt;
    const double off = std::abs(cross(p - at_v, q - at_v)) / std::sqrt(squared_distance(p, q));
    return off <= tolerance_ ? std::optional(other) : std::nullopt;
  }

  // All edges in line with edge `first`: back to where they start, then from there on.
  //
  //   from --- v --- v === v --- to      === is `first`
  void add_chain(std::size_t first, std::vector<Part>& parts, std::vector<Segment>& segments) {
    std::size_t start = first;
    VertexId from = edges_[first].a;
    while (const auto before = next(start, from)) {  // ends: lines do not close
      start = *before;
      from = other_end(start, from);
      if (start == first) break;
    }
    std::vector<std::size_t> chain;
    VertexId to = from;
    for (std::optional<std::size_t> edge = start; edge && !edges_[*edge].joined;) {
      edges_[*edge].joined = true;
      chain.push_back(*edge);
      to = other_end(*edge, to);
      edge = next(*edge, to);
    }
    for (const auto& curve : edges_[first].curves) {
      add_parts(chain, from, SegmentId(segments.size()), parts);
      segments.push_back({from, to, curve, 0, 1});
    }
  }

  void add_parts(const std::vector<std::size_t>& chain, VertexId from, SegmentId segment,
                 std::vector<Part>& parts) const {
    const double step = 1.0 / static_cast<double>(chain.size());
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const Edge& edge = edges_[chain[i]];
      double t_a = static_cast<double>(i) * step, t_b = static_cast<double>(i + 1) * step;
      const VertexId to = other_end(chain[i], from);
      if (edge.a != from) std::swap(t_a, t_b);
      parts.push_back({edge.e, segment, t_a, t_b});
      from = to;
    }
  }

  Mesh& mesh_;
  double tolerance_;
  std::vector<EdgesAt> edges_at_;
  std::vector<Edge> edges_;
};

}  // namespace

void join_segments_in_line(Mesh& mesh) { Joiner(mesh).run(); }

}  // namespace lepp
