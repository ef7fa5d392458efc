#pragma once

#include <memory>
#include <span>
#include <vector>

#include "adaptive.hpp"

namespace lepp::demo {

/// What two adaptive loops do differently: the mesh, how it is refined, and what is solved on it.
class AdaptiveScheme {
 public:
  virtual ~AdaptiveScheme() = default;
  virtual const Mesh& mesh() const = 0;
  /// The solution at the vertices; notes the unknowns, the iterations and the time.
  virtual Eigen::VectorXd solve(AdaptiveStep& step) = 0;
  /// \param u  the solution on the mesh as it is
  /// \return   false if nothing could be refined: edges are as short as coordinates allow
  virtual bool refine(std::span<const TriangleId> marked, const Eigen::VectorXd& u) = 0;
};

/// `problem` stays where it is while the scheme is in use.
std::unique_ptr<AdaptiveScheme> elements_by_bisection(const AdaptiveProblem& problem,
                                                      LinearSolver solver);
std::unique_ptr<AdaptiveScheme> boxes_by_delaunay(const AdaptiveProblem& problem,
                                                  LinearSolver solver);

}  // namespace lepp::demo
