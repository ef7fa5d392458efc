#include "first_guess.hpp"

namespace lepp::demo {

FirstGuess first_guess(const Mesh& mesh, const PoissonProblem& problem,
                       std::vector<double> values) {
  const auto fixed = fixed_values(mesh, problem);
  FirstGuess guess;
  guess.free.resize(fixed.size(), 0);
  for (std::size_t v = 0; v < fixed.size(); ++v) {
    if (fixed[v]) values[v] = fixed[v]->value;
    else guess.free[v] = 1;
    guess.unknowns += fixed[v] ? 0 : 1;
  }
  guess.u =
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  return guess;
}

}  // namespace lepp::demo
