#include "lepp/geometry/error.hpp"

namespace lepp {

Error::Error(ErrorKind kind, std::string where, std::string problem, std::string remedy)
    : std::runtime_error(where + ": " + problem + "; " + remedy),
      kind_(kind),
      where_(std::move(where)),
      problem_(std::move(problem)),
      remedy_(std::move(remedy)) {}

}  // namespace lepp
