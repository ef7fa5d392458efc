#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "support/gen_pslg.hpp"

namespace lepp::test {

struct StressOptions {
  std::uint64_t seed = 1;       ///< of the first case; the others follow one by one
  std::uint64_t count = 10000;  ///< cases
  double seconds = 0;           ///< stop after them; 0 means never
  std::uint32_t threads = 2;
  std::optional<Family> family;  ///< one only; else all in turn
  bool split = true;             ///< split crossings too, where there are any
  bool predicates = false;       ///< the predicates instead of PSLGs
  std::string folder = ".";      ///< where failing cases go
  bool save = false;             ///< write every case, failing or not
};

/// \return nothing, with a message on stderr, if the arguments are wrong
std::optional<StressOptions> parse_stress_options(int argc, char** argv);

}  // namespace lepp::test
