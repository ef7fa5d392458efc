#include "lepp/io/boundary_loops.hpp"

#include <algorithm>
#include <cmath>

#include "lepp/geometry/compensated_sum.hpp"
#include "lepp/geometry/predicates.hpp"

namespace lepp {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFFU;

// Boundary edges by the vertex they start at: almost always one, more where fans touch.
class Sides {
 public:
  explicit Sides(const Mesh& mesh) : mesh_(mesh), first_(mesh.vertex_count(), none) {
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const HalfEdge e{TriangleId(t), i};
        if (!mesh.is_boundary(e)) continue;
        std::uint32_t& first = first_[mesh.origin(e).index()];
        more_.push_back(first);
        first = static_cast<std::uint32_t>(sides_.size());
        sides_.push_back(e);
      }
    }
  }

  std::size_t size() const { return sides_.size(); }
  HalfEdge operator[](std::uint32_t i) const { return sides_[i]; }

  // The side after `i` around the area on its right: the first that leaves its end b, turning
  // counter-clockwise from b -> a.
  //
  //      mesh
  //   a ------ b       c: the next side is b -> c, whatever other fans meet in b beyond it
  //      none   \ mesh
  //              c
  std::uint32_t after(std::uint32_t i) const {
    const VertexId b = mesh_.destination(sides_[i]);
    std::uint32_t best = first_[b.index()];
    for (std::uint32_t k = more_[best]; k != none; k = more_[k]) {
      if (comes_before(sides_[i], sides_[k], sides_[best])) best = k;
    }
    return best;
  }

 private:
  bool comes_before(HalfEdge from, HalfEdge left, HalfEdge right) const {
    const Point a = mesh_.point(mesh_.origin(from)), b = mesh_.point(mesh_.destination(from));
    const Point p = mesh_.point(mesh_.destination(left)), q = mesh_.point(mesh_.destination(right));
    const int side_p = orient2d(b, a, p), side_q = orient2d(b, a, q);
    if (side_p != side_q) return side_p > side_q;  // below, exactly and above half a turn
    return orient2d(b, p, q) > 0;
  }

  const Mesh& mesh_;
  std::vector<std::uint32_t> first_, more_;
  std::vector<HalfEdge> sides_;
};

void measure(const Mesh& mesh, BoundaryLoop& loop) {
  const Point start = mesh.point(mesh.origin(loop.sides.front()));
  CompensatedSum twice;
  double terms = 0;
  for (const HalfEdge e : loop.sides) {
    const Point p = mesh.point(mesh.origin(e)) - start;
    const Point q = mesh.point(mesh.destination(e)) - start;
    twice.add(cross(p, q));
    terms += std::abs(p.x * q.y) + std::abs(p.y * q.x);
  }
  loop.area = 0.5 * twice.value();
  loop.uncertainty = 1e-12 * terms;
}

Point centroid(const Mesh& mesh, const BoundaryLoop& loop) {
  const Point start = mesh.point(mesh.origin(loop.sides.front()));
  Point sum{0, 0};
  for (const HalfEdge e : loop.sides) {
    const Point p = mesh.point(mesh.origin(e)) - start;
    const Point q = mesh.point(mesh.destination(e)) - start;
    sum = sum + cross(p, q) * (p + q);
  }
  return start + (1 / (6 * loop.area)) * sum;
}

double squared_distance_to_side(Point c, Point a, Point b) {
  const Point ab = b - a;
  const double s = std::clamp(dot(c - a, ab) / dot(ab, ab), 0.0, 1.0);
  return squared_distance(c, a + s * ab);
}

}  // namespace

std::vector<BoundaryLoop> boundary_loops(const Mesh& mesh) {
  const Sides sides(mesh);
  std::vector<bool> walked(sides.size(), false);
  std::vector<BoundaryLoop> loops;
  for (std::uint32_t first = 0; first < sides.size(); ++first) {
    if (walked[first]) continue;
    BoundaryLoop& loop = loops.emplace_back();
    for (std::uint32_t i = first; !walked[i]; i = sides.after(i)) {
      walked[i] = true;
      loop.sides.push_back(sides[i]);
    }
    measure(mesh, loop);
  }
  return loops;
}

std::vector<BoundaryLoop> simple_boundary_loops(const Mesh& mesh) {
  std::vector<std::uint32_t> place(mesh.vertex_count(), none);  // on the path, of the side from it
  std::vector<HalfEdge> path;
  std::vector<BoundaryLoop> loops;
  for (const BoundaryLoop& walk : boundary_loops(mesh)) {
    for (const HalfEdge e : walk.sides) {
      place[mesh.origin(e).index()] = static_cast<std::uint32_t>(path.size());
      path.push_back(e);
      const std::uint32_t back = place[mesh.destination(e).index()];
      if (back == none) continue;
      BoundaryLoop& loop = loops.emplace_back();
      loop.sides.assign(path.begin() + back, path.end());
      path.resize(back);
      for (const HalfEdge side : loop.sides) place[mesh.origin(side).index()] = none;
      measure(mesh, loop);
    }
  }
  return loops;
}

std::optional<Point> centroid_inside(const Mesh& mesh, const BoundaryLoop& hole) {
  const Point c = centroid(mesh, hole);
  const double least = 1e-4 * std::abs(hole.area);
  bool inside = false;
  for (const HalfEdge e : hole.sides) {  // crossings of the ray from c to the right
    const Point a = mesh.point(mesh.origin(e)), b = mesh.point(mesh.destination(e));
    if (!(squared_distance_to_side(c, a, b) > least)) return std::nullopt;
    const bool rises = b.y > c.y;
    if ((a.y > c.y) == rises) continue;
    const int turn = orient2d(a, b, c);
    if (turn == 0) return std::nullopt;
    if ((turn > 0) == rises) inside = !inside;
  }
  return inside ? std::optional(c) : std::nullopt;
}

}  // namespace lepp
