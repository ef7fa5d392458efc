#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lepp {

/// The double nearest to the number that a word of a grid file is, which may be NaN or an infinity;
/// nothing if it is no number. A plus sign may be there. Beyond the range of doubles it is an
/// infinity or 0.
std::optional<double> number_of(std::string_view word);

/// A word in quotation marks, at most 40 characters of it, for a message.
std::string quoted(std::string_view word);

}  // namespace lepp
