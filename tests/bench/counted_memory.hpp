#pragma once

#include <cstddef>

namespace lepp::test {

/// Bytes that this program holds now, and the most since the last call of restart_peak(). Counted by
/// the program's own operator new, and where large arrays are mapped; of all threads.
std::size_t bytes_held();
std::size_t peak_bytes();
void restart_peak();

}  // namespace lepp::test
