#pragma once

#include <filesystem>
#include <vector>

#include "lepp/refine/size_field.hpp"

namespace lepp {

/// Reads points with sizes: one "x y h" per line, h > 0 the longest edge wanted near (x, y);
/// '#' starts a comment.
/// \throw InputError  naming file and line: fields missing or too many, no number, h not above 0;
///                    a file without points; and as read_text_file()
std::vector<SizeSource> read_size_file(const std::filesystem::path& path);

}  // namespace lepp
