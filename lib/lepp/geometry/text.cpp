#include "lepp/geometry/text.hpp"

#include <array>
#include <charconv>

namespace lepp {

std::string to_text(double value) {
  std::array<char, 32> text;  // the longest shortest double has 24 characters
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string to_text(Point p) { return "(" + to_text(p.x) + ", " + to_text(p.y) + ")"; }

}  // namespace lepp
