#include "lepp/io/gmsh_tokens.hpp"

#include <algorithm>

namespace lepp {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Where the comment that starts at `at` ends, or `at` if none starts there.
std::size_t after_comment(std::string_view script, std::size_t at) {
  const auto end_of = [&](std::string_view mark) {
    const std::size_t found = script.find(mark, at + 2);
    return found == script.npos ? script.size() : found + mark.size();
  };
  if (script.substr(at, 2) == "//") return end_of("\n");
  if (script.substr(at, 2) == "/*") return end_of("*/");
  return at;
}

std::size_t after_number(std::string_view script, std::size_t at) {
  const auto skip_digits = [&] {
    while (at < script.size() && is_digit(script[at])) ++at;
  };
  skip_digits();
  if (at < script.size() && script[at] == '.') ++at;
  skip_digits();
  if (at < script.size() && (script[at] == 'e' || script[at] == 'E')) {
    std::size_t digit = at + 1;
    if (digit < script.size() && (script[digit] == '+' || script[digit] == '-')) ++digit;
    if (digit < script.size() && is_digit(script[digit])) {
      at = digit;
      skip_digits();
    }
  }
  return at;
}

GeoToken token_at(std::string_view script, std::size_t begin) {
  const char c = script[begin];
  GeoToken token;
  token.begin = begin;
  token.end = begin + 1;
  const bool fraction = c == '.' && begin + 1 < script.size() && is_digit(script[begin + 1]);
  if (is_letter(c)) {
    token.kind = GeoToken::Kind::name;
    while (token.end < script.size() &&
           (is_letter(script[token.end]) || is_digit(script[token.end])))
      ++token.end;
  } else if (is_digit(c) || fraction) {
    token.kind = GeoToken::Kind::number;
    token.end = after_number(script, begin);
  } else if (c == '"' || c == '\'') {
    token.kind = GeoToken::Kind::string;
    const std::size_t close = script.find(c, begin + 1);
    token.end = close == script.npos ? script.size() : close + 1;
    token.text = script.substr(begin + 1, std::min(close, script.size()) - begin - 1);
    return token;
  }
  token.text = script.substr(begin, token.end - begin);
  return token;
}

}  // namespace

std::vector<GeoToken> geo_tokens(std::string_view script) {
  std::vector<GeoToken> tokens;
  std::size_t line = 1, counted = 0;
  for (std::size_t at = 0; at < script.size();) {
    const std::size_t after = after_comment(script, at);
    if (after != at) {
      at = after;
      continue;
    }
    if (script[at] == ' ' || script[at] == '\t' || script[at] == '\n') {
      ++at;
      continue;
    }
    GeoToken token = token_at(script, at);
    line += static_cast<std::size_t>(
        std::count(script.begin() + static_cast<std::ptrdiff_t>(counted),
                   script.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    counted = at;
    token.line = line;
    at = token.end;
    tokens.push_back(token);
  }
  return tokens;
}

}  // namespace lepp
