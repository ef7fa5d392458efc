#include "lepp/io/number_word.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <limits>
#include <system_error>

namespace lepp {

namespace {

// Where a number that no double holds lies: above 1, or so close to 0? from_chars does not say.
// The first digit that is not 0 stands `place` places before the point, and the exponent moves it.
bool is_above_one(std::string_view number) {
  const std::size_t e = std::min(number.find_first_of("eE"), number.size());
  const std::string_view digits = number.substr(0, e);
  const std::size_t point = std::min(digits.find('.'), digits.size());
  const std::size_t first = digits.find_first_of("123456789");
  const auto place = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
  if (e == number.size()) return place > 0;
  std::string_view exponent = number.substr(e + 1);
  const bool negative = exponent.starts_with('-');
  if (negative || exponent.starts_with('+')) exponent.remove_prefix(1);
  std::int64_t size = 0;
  const auto error = std::from_chars(exponent.data(), exponent.data() + exponent.size(), size).ec;
  if (error != std::errc()) return !negative;  // more than any number of digits
  return place + (negative ? -size : size) > 0;
}

}  // namespace

std::optional<double> number_of(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size()) return std::nullopt;
  if (error == std::errc()) return value;
  if (error != std::errc::result_out_of_range) return std::nullopt;
  if (!is_above_one(word)) return 0;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return word.starts_with('-') ? -infinity : infinity;
}

std::string quoted(std::string_view word) {
  std::string shown(word.substr(0, 40));
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = '?';
  }
  return "\"" + shown + (word.size() > 40 ? "...\"" : "\"");
}

}  // namespace lepp
