// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>

namespace lepp::gmsh_helper {

/// Bounds processor time, address space and core files of this process.
void limit_resources(std::uint64_t cpu_seconds, std::uint64_t memory_bytes);

/// No file can grow from here on, no process can be started by other users than root. After
/// gmsh::initialize, which rewrites a preferences file.
void forbid_writing();

}  // namespace lepp::gmsh_helper
