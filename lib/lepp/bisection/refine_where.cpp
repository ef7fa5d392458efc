#include "lepp/bisection/refine_where.hpp"

#include <algorithm>
#include <cmath>

namespace lepp {

namespace {

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

double diameter(const Mesh& mesh, TriangleId t) {
  const auto [a, b, c] = mesh.corners(t);
  return std::sqrt(
      std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)}));
}

// After the first round only what that round has changed can be new to the list.
WhereReport refine_where(Forest& forest,
                         const std::function<bool(const Mesh&, TriangleId)>& is_to_be_cut,
                         const WhereOptions& options) {
  WhereReport report;
  std::vector<TriangleId> marked;
  for (std::size_t i = 0; i < forest.mesh().triangle_count(); ++i) {
    if (is_to_be_cut(forest.mesh(), TriangleId(i))) marked.emplace_back(i);
  }
  while (!marked.empty()) {  // ends: triangles shrink
    const std::size_t vertices = forest.mesh().vertex_count();
    if (options.max_vertices > 0 && vertices >= options.max_vertices) return report;
    if (options.progress && !options.progress(vertices)) return report;
    const Refinement round = forest.bisect(marked, options.bisect);
    ++report.rounds;
    std::vector<TriangleId> changed = round.refused;
    for (const auto& [whole, other] : round.triangles) {
      changed.push_back(whole);
      changed.push_back(other);
    }
    std::ranges::sort(changed);
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    marked.clear();
    for (const TriangleId t : changed) {
      if (is_to_be_cut(forest.mesh(), t)) marked.push_back(t);
    }
    append(report.done.vertices, round.vertices);
    append(report.done.triangles, round.triangles);
    if (round.triangles.empty()) {  // what is left cannot be cut
      report.done.refused = round.refused;
      return report;
    }
  }
  report.finished = true;
  return report;
}

}  // namespace lepp
