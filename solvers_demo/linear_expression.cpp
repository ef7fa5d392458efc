#include "linear_expression.hpp"

#include <charconv>
#include <cmath>

namespace lepp::demo {
namespace {

/// Takes a number without sign from the front of `text`.
std::optional<double> take_number(std::string_view& text) {
  double value = 0;
  if (text.empty() || text.front() == '-') return std::nullopt;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

bool take(std::string_view& text, char wanted) {
  if (text.empty() || text.front() != wanted) return false;
  text.remove_prefix(1);
  return true;
}

/// Takes "2", "x", "2*x", "y" or "2*y" and adds it, times sign.
bool take_term(std::string_view& text, double sign, LinearExpression& sum) {
  const auto number = take_number(text);
  if (number && !take(text, '*')) {
    sum.constant += sign * *number;
    return true;
  }
  const double factor = sign * number.value_or(1);
  if (take(text, 'x')) sum.x_factor += factor;
  else if (take(text, 'y')) sum.y_factor += factor;
  else return false;
  return true;
}

}  // namespace

std::optional<LinearExpression> parse_linear(std::string_view text) {
  LinearExpression sum;
  double sign = take(text, '-') ? -1 : 1;
  while (take_term(text, sign, sum)) {  // ends: each turn takes at least one character
    if (text.empty()) return sum;
    if (take(text, '+')) sign = 1;
    else if (take(text, '-')) sign = -1;
    else return std::nullopt;
  }
  return std::nullopt;
}

std::optional<double> parse_number(std::string_view text) {
  const double sign = take(text, '-') ? -1 : 1;
  const auto number = take_number(text);
  if (!number || !text.empty()) return std::nullopt;
  return sign * *number;
}

}  // namespace lepp::demo
