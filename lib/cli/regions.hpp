#pragma once

#include <string>
#include <vector>

#include "lepp/bisection/region.hpp"

namespace lepp::cli {

/// The region that a text describes: "disc X Y R", "box X0 Y0 X1 Y1", or "polygon FILE", a file of
/// lines "x y", one for each corner.
/// \throw InputError  for any other text, and as readers do for the file
Region read_region(const std::string& text);

}  // namespace lepp::cli
