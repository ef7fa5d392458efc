#include "lepp/io/loops.hpp"

#include <algorithm>
#include <unordered_map>

#include "lepp/triangulation/dual_graph.hpp"

namespace lepp {

namespace {

class Tracer {
 public:
  Tracer(const Mesh& mesh, MeshOutline& result) : mesh_(mesh), result_(result) {
    number_of_.assign(3 * mesh.triangle_count(), none);
    for (std::size_t i = 0; i < result.edges.size(); ++i) {
      number_of_[code(result.edges[i])] = i;
      if (const auto across = mesh.twin(result.edges[i])) number_of_[code(*across)] = i;
    }
    done_.assign(number_of_.size(), false);
  }

  /// All loops that start from a half-edge not visited yet.
  void trace(HalfEdge start) {
    if (done_[code(start)]) return;
    std::vector<HalfEdge> walk;
    HalfEdge e = start;
    do {  // next_on_boundary() permutes the half-edges of loops, so the walk comes back
      done_[code(e)] = true;
      walk.push_back(e);
      e = next_on_boundary(e);
    } while (e != start);
    split_into_loops(walk);
  }

  /// A constrained edge with different parts, or no mesh, on its two sides.
  bool is_on_boundary(HalfEdge e) const {
    if (!mesh_.is_constrained(e)) return false;
    const auto across = mesh_.twin(e);
    return !across || part(across->triangle) != part(e.triangle);
  }

  std::uint32_t part(TriangleId t) const { return result_.part_of_triangle[t.index()]; }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  static std::size_t code(HalfEdge e) { return 3 * e.triangle.index() + e.edge; }

  // Turns around e's destination inside the part until it meets the part's boundary again.
  HalfEdge next_on_boundary(HalfEdge e) const {
    HalfEdge next = next_edge(e);
    while (!is_on_boundary(next)) next = next_edge(*mesh_.twin(next));
    return next;
  }

  // A walk that passes a vertex twice is several loops that touch there.
  void split_into_loops(const std::vector<HalfEdge>& walk) {
    std::vector<HalfEdge> open;
    std::unordered_map<VertexId, std::size_t> starts_at;  // origin -> place in `open`
    for (const HalfEdge e : walk) {
      open.push_back(e);
      starts_at[mesh_.origin(e)] = open.size() - 1;
      const auto closed = starts_at.find(mesh_.destination(e));
      if (closed == starts_at.end()) continue;
      const auto first = open.begin() + static_cast<std::ptrdiff_t>(closed->second);
      add_loop({first, open.end()});
      for (auto it = first; it != open.end(); ++it) starts_at.erase(mesh_.origin(*it));
      open.erase(first, open.end());
    }
  }

  void add_loop(const std::vector<HalfEdge>& half_edges) {
    OutlinePart& part_here = result_.parts[part(half_edges.front().triangle)];
    Loop loop;
    double area = 0;
    const Point origin = mesh_.point(mesh_.origin(half_edges.front()));
    for (const HalfEdge e : half_edges) {
      const std::size_t edge = number_of_[code(e)];
      loop.push_back({edge, result_.edges[edge] == e});
      area +=
          cross(mesh_.point(mesh_.origin(e)) - origin, mesh_.point(mesh_.destination(e)) - origin);
    }
    // Counter-clockwise: the outer loop.
    const auto at = area > 0 ? part_here.loops.begin() : part_here.loops.end();
    part_here.loops.insert(at, std::move(loop));
  }

  const Mesh& mesh_;
  MeshOutline& result_;
  std::vector<std::size_t> number_of_;
  std::vector<bool> done_;
};

}  // namespace

MeshOutline outline(const Mesh& mesh) {
  MeshOutline result;
  const DualComponents components = dual_components(mesh);
  result.part_of_triangle = components.of_triangle;
  result.parts.resize(components.count);
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const TriangleId t(i);
    result.parts[result.part_of_triangle[i]].region = mesh.region(t);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto across = mesh.twin({t, k});
      if (!mesh.is_constrained({t, k}) || (across && *across < HalfEdge{t, k})) continue;
      result.edges.push_back({t, k});  // each edge once
    }
  }
  Tracer tracer(mesh, result);
  for (std::size_t i = 0; i < result.edges.size(); ++i) {
    const HalfEdge e = result.edges[i];
    if (!tracer.is_on_boundary(e)) {
      result.parts[tracer.part(e.triangle)].embedded.push_back(i);
      continue;
    }
    tracer.trace(e);
    if (const auto across = mesh.twin(e)) tracer.trace(*across);
  }
  return result;
}

}  // namespace lepp
