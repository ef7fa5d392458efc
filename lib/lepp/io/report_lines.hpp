#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace lepp {

// The lines of reports for people: a label and, in one column, what there is to say.
inline void add_line(std::string& text, std::string_view label, const std::string& value) {
  text += fmt::format("{:<34}{}\n", label, value);
}

inline std::string answer(bool yes) { return yes ? "yes" : "no"; }

/// "3 budget, 1 cancelled": how many of each kind there are, those that do not occur left out.
/// \tparam Kind  an enumeration with to_string(); `counts` are in its order
template <class Kind>
std::string counted(const auto& counts) {
  std::string text;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", counts[i],
                        to_string(static_cast<Kind>(i)));
  }
  return text.empty() ? "0" : text;
}

}  // namespace lepp
