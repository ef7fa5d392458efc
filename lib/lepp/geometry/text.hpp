#pragma once

#include <string>
#include <string_view>

#include "lepp/geometry/point.hpp"

namespace lepp {

/// The shortest text that reads back as the same double, in every locale: "0.1", "1e+30".
std::string to_text(double value);

/// The same without an exponent: "1000000", "0.00001".
std::string to_decimal_text(double value);

/// "(x, y)", each coordinate as above: how every message names a place.
std::string to_text(Point p);

/// With the letters A to Z small, in every locale.
std::string lower_case(std::string_view text);

}  // namespace lepp
