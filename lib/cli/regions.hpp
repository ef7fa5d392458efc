#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lepp/bisection/region.hpp"

namespace lepp::cli {

/// The file that "polygon FILE" names, blanks around it left out; nothing for any other text.
/// \throw InputError  for "polygon" without a file
std::optional<std::filesystem::path> polygon_file(const std::string& text);

/// The region that a text describes: "disc X Y R", "box X0 Y0 X1 Y1", or "polygon FILE", a file of
/// lines "x y", one for each corner; blanks before, between and after the words do not count.
/// \throw InputError  for any other text, and as readers do for the file
Region read_region(const std::string& text);

}  // namespace lepp::cli
