#include "support/plain/delaunay.hpp"

#include <algorithm>
#include <numeric>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/flip.hpp"

namespace lepp::plain {

namespace {

// Mesh::leaving of a hull vertex is the hull edge that leaves it counter-clockwise; `before` holds
// the hull vertex in front of it.
class Sweep {
 public:
  explicit Sweep(Mesh& mesh) : mesh_(mesh), before_(mesh.vertex_count()) {
    order_.resize(mesh.vertex_count());
    std::iota(order_.begin(), order_.end(), 0U);
    const auto points = mesh.points();
    std::ranges::sort(order_, {}, [&](std::uint32_t v) { return points[v]; });
  }

  bool run() {
    const std::size_t apex = first_off_the_line();
    if (apex == order_.size()) return false;
    start_fan(apex);
    for (std::size_t i = apex + 1; i < order_.size(); ++i) add(vertex(i));
    return true;
  }

 private:
  VertexId vertex(std::size_t i) const { return VertexId(order_[i]); }
  int side(VertexId a, VertexId b, VertexId c) const {
    return orient2d(mesh_.point(a), mesh_.point(b), mesh_.point(c));
  }

  std::size_t first_off_the_line() const {
    std::size_t i = 2;
    while (i < order_.size() && side(vertex(0), vertex(1), vertex(i)) == 0) ++i;
    return std::min(i, order_.size());
  }

  // Vertices 0 .. apex-1 lie on a line in order; join them all to `apex`.
  void start_fan(std::size_t apex) {
    const VertexId p = vertex(apex);
    const bool left = side(vertex(0), vertex(1), p) > 0;
    std::optional<TriangleId> previous;
    for (std::size_t i = 0; i + 1 < apex; ++i) {
      const VertexId a = vertex(i), b = vertex(i + 1);
      const TriangleId t = left ? mesh_.add_triangle(p, a, b, SurfaceId(0U))
                                : mesh_.add_triangle(p, b, a, SurfaceId(0U));
      mesh_.unlink({t, 0});
      if (!previous) {
        mesh_.unlink({t, left ? 2U : 1U});
      } else {  // the edge between p and a: opposite b here, opposite the vertex before a there
        mesh_.link({t, left ? 2U : 1U}, {*previous, left ? 1U : 2U});
        suspects_.push_back({t, left ? 2U : 1U});
      }
      previous = t;
    }
    mesh_.unlink({*previous, left ? 1U : 2U});
    for (std::size_t i = 0; i <= apex; ++i) before_[next(vertex(i)).index()] = vertex(i);
    restore_delaunay(mesh_, suspects_);
    last_ = p;
  }

  VertexId next(VertexId hull_vertex) const {
    return mesh_.destination(mesh_.leaving(hull_vertex));
  }
  VertexId before(VertexId hull_vertex) const { return before_[hull_vertex.index()]; }
  bool sees(VertexId p, VertexId hull_vertex) const {
    return side(hull_vertex, next(hull_vertex), p) < 0;
  }

  // p is lexicographically beyond all vertices so far, so it sees a hull edge at the one added
  // last; the edges it sees form a chain around that vertex, from `from` to `to`:
  //
  //      from <---- p          each hull edge a -> b of the chain becomes the base of a new
  //       a  b     /           triangle (p, b, a)
  //         ..  to
  void add(VertexId p) {
    VertexId from = last_;
    while (sees(p, before(from))) from = before(from);
    VertexId a = from;
    std::optional<TriangleId> previous;
    std::optional<HalfEdge> from_p;
    while (sees(p, a)) {
      const HalfEdge hull = mesh_.leaving(a);
      const VertexId b = mesh_.destination(hull);
      const TriangleId t = mesh_.add_triangle(p, b, a, SurfaceId(0U));
      mesh_.link({t, 0}, hull);
      suspects_.push_back({t, 0});
      if (previous) mesh_.link({t, 1}, {*previous, 2});
      else from_p = HalfEdge{t, 1};
      previous = t;
      a = b;
    }
    mesh_.unlink(*from_p);
    mesh_.unlink({*previous, 2});
    before_[p.index()] = from;
    before_[a.index()] = p;
    last_ = p;
    restore_delaunay(mesh_, suspects_);
  }

  Mesh& mesh_;
  std::vector<std::uint32_t> order_;
  std::vector<VertexId> before_;
  std::vector<HalfEdge> suspects_;
  VertexId last_;
};

}  // namespace

bool triangulate_vertices(Mesh& mesh) { return Sweep(mesh).run(); }

}  // namespace lepp::plain
