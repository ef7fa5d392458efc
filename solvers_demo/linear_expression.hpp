#pragma once

#include <optional>
#include <string_view>

#include "lepp/geometry/point.hpp"

namespace lepp::demo {

/// constant + x_factor x + y_factor y: what a value on the command line may be.
struct LinearExpression {
  double constant = 0, x_factor = 0, y_factor = 0;
  double operator()(Point p) const { return constant + x_factor * p.x + y_factor * p.y; }
};

/// Reads a sum of terms such as "300", "-x", "2*y": "1.5+2*x-1e-3*y". No spaces.
/// \return nothing if the text is anything else, or a number is not finite
std::optional<LinearExpression> parse_linear(std::string_view text);

/// Reads one finite number and nothing else.
std::optional<double> parse_number(std::string_view text);

}  // namespace lepp::demo
