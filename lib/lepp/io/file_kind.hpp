#pragma once

#include <filesystem>
#include <string>

#include "lepp/geometry/text.hpp"

namespace lepp {

/// What a file is by its name: ".obj" of a.obj and A.OBJ.
inline std::string file_kind(const std::filesystem::path& path) {
  return lower_case(path.extension().string());
}

}  // namespace lepp
