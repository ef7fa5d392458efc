#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lepp/triangulation/constrained_delaunay.hpp"

namespace lepp::test {

struct CaseReport {
  std::optional<std::string> failure;
  bool crosses = false;        ///< the oracle found crossing segments
  bool refused_split = false;  ///< they were split, then holes, seeds or no area refused
  bool made_mesh = false;
};

/// Everything we can ask about one PSLG: without and, where they cross,
/// with splitting (unless `crossings` says refuse), all invariants; for one seed
/// in 16 also the plain kernel, a second run, and the segments in another order.
CaseReport run_case(const Pslg& pslg, std::uint64_t seed, Crossings crossings);

}  // namespace lepp::test
