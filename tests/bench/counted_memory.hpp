#pragma once

#include <cstddef>

namespace lepp::test {

/// Bytes of the free store that this program holds now, and the most since the last call of
/// restart_peak(). Counted by the program's own operator new, of all threads.
std::size_t bytes_held();
std::size_t peak_bytes();
void restart_peak();

}  // namespace lepp::test
