#include "stress/stress_case.hpp"

#include <algorithm>

#include "support/mesh_edges.hpp"
#include "support/random.hpp"
#include "support/trial.hpp"

namespace lepp::test {

namespace {

bool have_same_edges(const Mesh& a, const Mesh& b) {
  const SortedEdges ours(a), theirs(b);
  return std::ranges::equal(ours.entries(), theirs.entries(), {}, &SortedEdges::Entry::key,
                            &SortedEdges::Entry::key);
}

Pslg with_shuffled_segments(Pslg pslg, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = pslg.segments.size(); i > 1; --i) {
    std::swap(pslg.segments[i - 1], pslg.segments[random.below(static_cast<std::uint32_t>(i))]);
  }
  return pslg;
}

std::optional<std::string> compare(const Triangulation& result, const Pslg& pslg,
                                   std::uint64_t seed) {
  if (auto difference = difference_from_plain(result, pslg)) return difference;
  if (!are_same(result.mesh, constrained_delaunay(pslg).mesh)) return "a second run differs";
  const Mesh shuffled = constrained_delaunay(with_shuffled_segments(pslg, seed)).mesh;
  if (is_unique(result.mesh) && !have_same_edges(result.mesh, shuffled)) {
    return "segments in another order give other edges";
  }
  return std::nullopt;
}

}  // namespace

CaseReport run_case(const Pslg& pslg, std::uint64_t seed, Crossings crossings) {
  const Arrangement arrangement = arrange(pslg);
  CaseReport report;
  report.crosses = !arrangement.crossings.empty();
  Trial trial = try_pslg(pslg, arrangement, Crossings::refuse);
  if (!trial.failure && trial.result && seed % 16 == 0) {
    trial.failure = compare(*trial.result, pslg, seed);
  }
  if (!trial.failure && report.crosses && crossings == Crossings::split)
    trial = try_pslg(pslg, arrangement, Crossings::split);
  report.refused_split = trial.refused_split;
  report.made_mesh = trial.result.has_value();
  report.failure = std::move(trial.failure);
  return report;
}

}  // namespace lepp::test
