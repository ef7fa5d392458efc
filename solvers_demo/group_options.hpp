#pragma once

#include <string>
#include <vector>

#include "problem.hpp"

namespace lepp::demo {

/// What the user typed after each option, GROUP=VALUE.
/// GROUP is a name or a tag of a physical group; in a mesh without groups of that dimension, the
/// tag of a surface or curve (an attribute or a marker of Triangle's files).
struct GroupOptions {
  std::vector<std::string> diffusion = {};  ///< GROUP=D
  std::vector<std::string> source = {};     ///< GROUP=F, F as linear_expression.hpp reads it
  std::vector<std::string> dirichlet = {};  ///< GROUP=V; V like F
  std::vector<std::string> neumann = {};    ///< GROUP=G; G like F
  std::vector<std::string> robin = {};      ///< GROUP=ALPHA,V; V like F
};

/// What can be said of the options without a mesh.
/// \throw InputError  no GROUP=VALUE, or a value that cannot be read
void check_form(const GroupOptions& options);

/// The problem these options describe on this mesh. D is 1 if no --diffusion is given at all.
/// \throw InputError  a value that cannot be read; a group that is not there (the message lists
///        those that are); a surface without D, or with two; a group without an edge in the mesh,
///        or with two Dirichlet values
PoissonProblem problem_from(const GroupOptions& options, const Mesh& mesh);

}  // namespace lepp::demo
