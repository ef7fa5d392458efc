#include "lepp/refine/left_alone.hpp"

#include <algorithm>
#include <limits>

namespace lepp {

namespace {

// Refinement of one fan is graded by powers of two: a few more cuts are no cascade.
constexpr double much_shorter = 1.0 / 64;

// By vertex, for the first `count`: the squared length of its shortest constrained edge.
std::vector<double> shortest_constrained(const Mesh& mesh, std::size_t count) {
  std::vector<double> shortest(count, std::numeric_limits<double>::infinity());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      if (!mesh.is_constrained(e)) continue;
      const VertexId a = mesh.origin(e), b = mesh.destination(e);
      const double length = squared_distance(mesh.point(a), mesh.point(b));
      for (const VertexId v : {a, b}) {
        if (v.index() < count) shortest[v.index()] = std::min(shortest[v.index()], length);
      }
    }
  }
  return shortest;
}

}  // namespace

bool LeftAlone::contains(const Mesh& mesh, TriangleId t) const {
  const auto is_there = [&](VertexId v) { return v.index() < at_.size() && at_[v.index()] != 0; };
  return std::ranges::any_of(mesh.vertices(t), [&](VertexId v) {
    const VertexOrigin& origin = mesh.origin_of(v);
    if (origin.kind != VertexOrigin::Kind::on_segment) return is_there(v);
    return std::ranges::any_of(mesh.segments_of(SegmentSetId(origin.index)), [&](SegmentId s) {
      const Segment& segment = mesh.segments()[s.index()];
      return is_there(segment.a) || is_there(segment.b);
    });
  });
}

bool LeftAlone::add_shrunken(const Mesh& attempt, const Mesh& plain) {
  const auto here = shortest_constrained(attempt, at_.size());
  const auto there = shortest_constrained(plain, at_.size());
  bool any = false;
  for (std::size_t v = 0; v < at_.size(); ++v) {
    if (at_[v] != 0 || !(here[v] < much_shorter * much_shorter * there[v])) continue;
    at_[v] = 1;
    any = true;
  }
  return any;
}

}  // namespace lepp
