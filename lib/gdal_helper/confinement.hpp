#pragma once

#include <cstdint>

namespace lepp::gdal_helper {

/// Bounds processor time, address space and core files, and forbids what reading a file does not
/// need: sockets, other programs, and growing, shortening, renaming or removing files.
void confine(std::uint64_t cpu_seconds, std::uint64_t memory_bytes);

}  // namespace lepp::gdal_helper
