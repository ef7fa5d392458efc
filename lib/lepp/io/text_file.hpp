#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace lepp {

/// A text file in memory, without byte-order mark.
struct TextFile {
  std::string name;  ///< as the caller wrote it, for messages
  std::string text;
};

/// Reads a whole file.
/// \throw InputError   no such file, a folder or a device, empty, UTF-16, or a NUL byte (and where)
/// \throw RefusedError longer than `size_limit` bytes; nothing of that size is allocated
TextFile read_text_file(const std::filesystem::path& path,
                        std::uint64_t size_limit = std::uint64_t{1} << 31);

}  // namespace lepp
