#pragma once

#include <cstddef>
#include <new>

namespace lepp::test {

/// While one of these lives, `allowed` allocations succeed and the next one throws std::bad_alloc;
/// then all succeed again. For programs with failing_memory.cpp linked in.
class FailingMemory {
 public:
  explicit FailingMemory(std::size_t allowed);
  FailingMemory(const FailingMemory&) = delete;
  FailingMemory& operator=(const FailingMemory&) = delete;
  ~FailingMemory();
};

/// Calls work() and, where it throws for want of memory, after_failure(), with one allocation more
/// each time, until work() succeeds.
/// \return how often it failed
template <class Prepare, class Work, class AfterFailure>
std::size_t fail_in_turn(Prepare prepare, Work work, AfterFailure after_failure) {
  for (std::size_t allowed = 0;; ++allowed) {
    auto subject = prepare();
    try {
      const FailingMemory failing(allowed);
      work(subject);
      return allowed;
    } catch (const std::bad_alloc&) {
    }
    after_failure(subject);
  }
}

}  // namespace lepp::test
