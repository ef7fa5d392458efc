#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace lepp {

/// Writes a PNG of 8-bit red, green and blue, row by row from the top; deflate in stored blocks,
/// that is, not compressed.
/// \pre   colors.size() == 3 * width * height, width and height 1 to 2^16
/// \throw OutputError
void write_png(const std::filesystem::path& path, std::size_t width, std::size_t height,
               std::span<const std::uint8_t> colors);

}  // namespace lepp
