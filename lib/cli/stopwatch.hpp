#pragma once

#include <chrono>

namespace lepp::cli {

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Runs `work` and returns how many seconds it took.
template <class Work>
double timed(Work work) {
  const auto start = Clock::now();
  work();
  return seconds_since(start);
}

}  // namespace lepp::cli
