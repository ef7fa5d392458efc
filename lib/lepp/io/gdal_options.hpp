#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>

namespace lepp {

/// About the program lepp-gdal, which reads everything that GDAL does.
struct GdalOptions {
  double seconds = 600;                              ///< wall-clock limit for one file
  std::size_t memory_bytes = std::size_t{4} << 30U;  ///< address space of the helper
  /// The program, if not what LEPP_GDAL names, beside this program or in ../libexec/lepp.
  std::optional<std::filesystem::path> helper = {};
  std::function<bool()> keep_going = {};  ///< asked about once a second; false ends it
};

}  // namespace lepp
