#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace lepp {

/// Number of nodes of a Gmsh element type, for the types that are common in files.
std::optional<std::size_t> nodes_of_gmsh_type(int type);

/// How many elements of each type a file has.
using GmshElementCounts = std::map<int, std::uint64_t>;

/// \throw InputError unless there are 3-node triangles, and beside them only lines and points
void check_gmsh_elements(const GmshElementCounts& counts, const std::string& source);

}  // namespace lepp
