#pragma once

#include <cstddef>
#include <optional>

#include "lepp/refine/refine.hpp"

namespace lepp {

/// How long a loop of refinement may go on: up to a number of vertices, and until the caller's
/// progress() says stop.
class Allowance {
 public:
  Allowance(const Mesh& mesh, const RefineOptions& options, std::size_t budget)
      : mesh_(mesh), options_(options), budget_(budget) {}

  /// Once false, it stays so.
  bool may_go_on() {
    if (mesh_.vertex_count() >= budget_) {
      stopped_ = Reason::budget;
    } else if (options_.progress && !options_.progress(mesh_.vertex_count())) {
      stopped_ = Reason::cancelled;
    }
    return !stopped_;
  }
  /// Why it ended, if it did.
  std::optional<Reason> stopped() const { return stopped_; }

 private:
  const Mesh& mesh_;
  const RefineOptions& options_;
  std::size_t budget_;
  std::optional<Reason> stopped_;
};

}  // namespace lepp
