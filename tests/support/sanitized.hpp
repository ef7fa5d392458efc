#pragma once

#include <cstdint>

namespace lepp::test {

/// How many cases to run: fewer under sanitizers, which are some twenty times slower.
constexpr std::uint64_t cases(std::uint64_t count) {
#if defined(__SANITIZE_ADDRESS__)
  return count / 20 + 1;
#else
  return count;
#endif
}

}  // namespace lepp::test
