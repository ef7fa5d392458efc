#include "lepp/bisection/refine_where.hpp"

#include <algorithm>
#include <cmath>

namespace lepp {

namespace {

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

void sort_once(std::vector<TriangleId>& list) {
  std::ranges::sort(list);
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

// The triangles that a round has changed, and those it left, once each.
std::vector<TriangleId> touched_by(const Refinement& round) {
  std::vector<TriangleId> touched = round.refused;
  for (const auto& [whole, other] : round.triangles) {
    touched.push_back(whole);
    touched.push_back(other);
  }
  sort_once(touched);
  return touched;
}

void add_round(Refinement& all, const Refinement& round) {
  append(all.vertices, round.vertices);
  append(all.triangles, round.triangles);
  append(all.refused, round.refused);
  sort_once(all.refused);
  all.limited = round.limited;
}

}  // namespace

double diameter(const Mesh& mesh, TriangleId t) {
  const auto [a, b, c] = mesh.corners(t);
  return std::sqrt(
      std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)}));
}

// After the first round only what that round has changed can be new to the list.
RefineWhereReport refine_where(Forest& forest,
                               const std::function<bool(const Mesh&, TriangleId)>& is_to_be_cut,
                               const WhereOptions& options) {
  RefineWhereReport report;
  std::vector<TriangleId> marked;
  for (std::size_t i = 0; i < forest.mesh().triangle_count(); ++i) {
    if (is_to_be_cut(forest.mesh(), TriangleId(i))) marked.emplace_back(i);
  }
  while (!marked.empty()) {  // ends: triangles shrink
    if (options.progress && !options.progress(forest.mesh().vertex_count())) return report;
    const Refinement round = forest.bisect(marked, options.bisect);
    ++report.rounds;
    add_round(report.done, round);
    if (round.limited || round.triangles.empty()) return report;  // or what is left cannot be cut
    marked = touched_by(round);
    std::erase_if(marked, [&](TriangleId t) { return !is_to_be_cut(forest.mesh(), t); });
  }
  report.finished = true;
  return report;
}

}  // namespace lepp
