#pragma once

#include <future>
#include <optional>
#include <system_error>

namespace lepp {

/// Runs both pieces of work, at the same time if `threads` is at least 2 and the system gives a
/// thread; else one after the other. They must not write what the other one reads.
/// \throw  what they throw, once both have ended; if both throw, the error of the first. One after
///         the other, the second is not started if the first throws.
template <class First, class Second>
void in_parallel(unsigned threads, First first, Second second) {
  std::optional<std::future<void>> other;
  if (threads >= 2) {
    try {
      other = std::async(std::launch::async, [&second] { second(); });
    } catch (const std::system_error&) {  // no thread to be had: one after the other
    }
  }
  first();  // if this throws, the future's destructor waits for the other one
  if (other) other->get();
  else second();
}

}  // namespace lepp
