#pragma once

#include <vector>

#include "linear_system.hpp"

namespace lepp::demo {

/// What is left to find, and a first guess.
struct FirstGuess {
  std::vector<char> free;  ///< one per vertex: 0 where a value is given
  Eigen::VectorXd u;       ///< with the given values
  std::size_t unknowns = 0;
};

/// \param values  one per vertex, for those that are free
FirstGuess first_guess(const Mesh& mesh, const PoissonProblem& problem, std::vector<double> values);

}  // namespace lepp::demo
