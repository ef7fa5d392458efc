#include "lepp/refine/size_point.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/triangulation/sharp_vertex.hpp"
#include "lepp/triangulation/split_constrained.hpp"

namespace lepp {

namespace {

// A base up to so many times the wanted length belongs to the front.
constexpr double longest_base = 1.5;
// Parts of constrained edges may be so much longer than wanted.
constexpr double longest_part = 1.1;

Point centroid(Point a, Point b, Point c) { return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3}; }

// Into how many equal parts `e` must be cut.
double parts(const Mesh& mesh, const SizeTest& size, HalfEdge e) {
  const Point a = mesh.point(mesh.origin(e)), b = mesh.point(mesh.destination(e));
  double wanted = size.wanted_edge(midpoint(a, b), mesh.region(e.triangle));
  if (const auto across = mesh.twin(e)) {
    wanted = std::min(wanted, size.wanted_edge(midpoint(a, b), mesh.region(across->triangle)));
  }
  const double length = std::sqrt(squared_distance(a, b));
  return std::max(1.0, std::ceil(length / (longest_part * wanted) - 1e-6));
}

bool ends_sharply(const Mesh& mesh, HalfEdge e) {
  const auto is_sharp = [&](VertexId v) { return mesh.is_input(v) && fan_at(mesh, e, v).exists(); };
  return is_sharp(mesh.origin(e)) || is_sharp(mesh.destination(e));
}

struct Ends {
  VertexId a, b;
};

}  // namespace

bool SizePoint::is_on_front(TriangleId t) const {
  const auto [a, b, c] = mesh_.corners(t);
  const double shortest =
      std::min({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
  const double wanted = size_.wanted_edge(centroid(a, b, c), mesh_.region(t));
  return shortest <= longest_base * longest_base * wanted * wanted;
}

Point SizePoint::operator()(TriangleId t, Point off_centre) const {
  const auto [a, b, c] = mesh_.corners(t);
  Point p = a, q = b;
  if (squared_distance(b, c) < squared_distance(p, q)) p = b, q = c;
  if (squared_distance(c, a) < squared_distance(p, q)) p = c, q = a;
  const Point middle = midpoint(p, q), base = q - p;
  const double wanted = size_.wanted_edge(middle, mesh_.region(t));
  const double squared_height = wanted * wanted - 0.25 * dot(base, base);
  const double least = 0.25 * dot(base, base);  // or the new triangle would be obtuse
  const double height = std::sqrt(std::max(squared_height, least));
  const double far = std::sqrt(squared_distance(middle, off_centre));
  if (!(height < far)) return off_centre;
  return middle + height / far * (off_centre - middle);
}

void cut_evenly(Mesh& mesh, const SizeTest& size, double floor,
                const std::function<bool()>& may_go_on) {
  if (!size.any()) return;
  std::vector<Ends> pending;
  for (std::size_t i = mesh.triangle_count(); i-- > 0;) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdge e{TriangleId(i), k};
      const auto across = mesh.twin(e);
      if (!mesh.is_constrained(e) || (across && *across < e)) continue;
      pending.push_back({mesh.origin(e), mesh.destination(e)});
    }
  }
  while (!pending.empty() && may_go_on()) {  // ends: by the floor
    const Ends ends = pending.back();
    pending.pop_back();
    const auto e = mesh.find_edge(ends.a, ends.b);
    if (!e) continue;
    const double n = parts(mesh, size, *e);
    if (n < 2 || ends_sharply(mesh, *e)) continue;
    const double length = std::sqrt(squared_distance(mesh.point(ends.a), mesh.point(ends.b)));
    const ConstrainedSplit split =
        std::fmod(n, 2) == 0
            ? split_halfway(mesh, *e, floor)
            : split_at_distance(mesh, *e, ends.a, std::floor(n / 2) / n * length, floor);
    if (split.vertices.empty()) continue;
    pending.push_back({split.vertices.front(), ends.b});
    pending.push_back({ends.a, split.vertices.front()});
  }
}

}  // namespace lepp
