#include "lepp/geometry/text.hpp"

#include <array>
#include <charconv>

namespace lepp {

std::string to_text(double value) {
  std::array<char, 32> text;  // the longest shortest double has 24 characters
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string to_decimal_text(double value) {
  std::array<char, 512> text;  // 5e-324 has 326 characters, 1e308 has 309
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed).ptr;
  return {text.data(), end};
}

std::string to_text(Point p) {
  std::string text = to_text(p.x);
  text.insert(0, 1, '(');
  text += ", ";
  text += to_text(p.y);
  text += ')';
  return text;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

}  // namespace lepp
