#include "problem.hpp"

#include <algorithm>
#include <utility>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/text.hpp"

namespace lepp::demo {
namespace {

bool belongs_to(const Mesh& mesh, HalfEdge e, const BoundaryPart& part) {
  const auto owners = mesh.segments_of(e);
  return std::any_of(owners.begin(), owners.end(), [&](SegmentId s) {
    const auto curve = mesh.segments()[s.index()].curve;
    return curve && std::find(part.curves.begin(), part.curves.end(), *curve) != part.curves.end();
  });
}

std::vector<VertexId> vertices_of(const Mesh& mesh, const BoundaryPart& part) {
  std::vector<VertexId> found;
  for (const HalfEdge e : edges_of(mesh, part)) {
    found.push_back(mesh.origin(e));
    found.push_back(mesh.destination(e));
  }
  for (const PointEntityId p : part.points) found.push_back(mesh.entities()[p].vertex);
  return found;
}

/// Marks everything that edges connect to the marked vertices.
void spread(const Mesh& mesh, std::vector<char>& marked) {
  std::vector<std::vector<VertexId>> neighbours(mesh.vertex_count());
  for (const Triangle& t : mesh.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      neighbours[t.vertices[i].index()].push_back(t.vertices[next_corner(i)]);
      neighbours[t.vertices[i].index()].push_back(t.vertices[previous_corner(i)]);
    }
  }
  std::vector<VertexId> front;
  for (std::size_t v = 0; v < marked.size(); ++v) {
    if (marked[v]) front.emplace_back(v);
  }
  while (!front.empty()) {  // ends: a vertex enters once, when it is marked
    const VertexId v = front.back();
    front.pop_back();
    for (const VertexId n : neighbours[v.index()]) {
      if (std::exchange(marked[n.index()], 1) == 0) front.push_back(n);
    }
  }
}

}  // namespace

std::size_t region_count(const Mesh& mesh) {
  std::size_t count = 0;
  for (const Triangle& t : mesh.triangles()) count = std::max(count, t.region().index() + 1);
  return count;
}

std::vector<HalfEdge> edges_of(const Mesh& mesh, const BoundaryPart& part) {
  std::vector<HalfEdge> found;
  if (part.curves.empty()) return found;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      if (!mesh.is_constrained(e)) continue;
      const auto twin = mesh.twin(e);
      if (twin && *twin < e) continue;  // the other side has been asked
      if (belongs_to(mesh, e, part)) found.push_back(e);
    }
  }
  return found;
}

std::vector<std::optional<FixedValue>> fixed_values(const Mesh& mesh,
                                                    const PoissonProblem& problem) {
  std::vector<std::optional<FixedValue>> fixed(mesh.vertex_count());
  for (std::size_t i = 0; i < problem.dirichlet.size(); ++i) {
    const Dirichlet& condition = problem.dirichlet[i];
    for (const VertexId v : vertices_of(mesh, condition.part)) {
      auto& at = fixed[v.index()];
      if (!at) at = FixedValue{condition.value(mesh.point(v)), i};
    }
  }
  return fixed;
}

void check_unique(const Mesh& mesh, const PoissonProblem& problem) {
  std::vector<char> tied(mesh.vertex_count(), 0);
  const auto tie = [&](const BoundaryPart& part) {
    for (const VertexId v : vertices_of(mesh, part)) tied[v.index()] = 1;
  };
  for (const Dirichlet& condition : problem.dirichlet) tie(condition.part);
  for (const Robin& condition : problem.robin) tie(condition.part);
  spread(mesh, tied);
  const auto loose = std::find(tied.begin(), tied.end(), 0);
  if (loose == tied.end()) return;
  const VertexId v(static_cast<std::size_t>(loose - tied.begin()));
  throw InputError(
      "the part of the mesh around " + to_text(mesh.point(v)),
      "has no Dirichlet or Robin condition, so a constant can be added to any solution",
      "give --dirichlet or --robin for a group on its boundary");
}

}  // namespace lepp::demo
