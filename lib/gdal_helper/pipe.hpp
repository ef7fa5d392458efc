#pragma once

#include <cstddef>
#include <span>

namespace lepp::gdal_helper {

/// Writes to the inherited descriptor 3. Ends the process if nobody reads.
void send(std::span<const std::byte> bytes);

}  // namespace lepp::gdal_helper
