#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lepp::cli {

/// The number that `text` is, if all of it is one.
template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// What the values of options must be. Each message says what to give, in one line.
CLI::Validator number_from(double least, double most);
CLI::Validator number_above_zero();
CLI::Validator finite_number();
/// \param least  0 or more
CLI::Validator whole_number_from(std::uint64_t least);
/// NAME=VALUE with a value above 0.
CLI::Validator named_size();

/// Turns one of the names, in small or capital letters, into what it stands for.
template <class Choice>
CLI::Validator choice_of(const std::vector<std::pair<std::string, Choice>>& choices) {
  return {[choices](std::string& text) {
            std::string names;
            for (const auto& [name, choice] : choices) {
              if (CLI::detail::to_lower(text) == name) {
                text = std::to_string(static_cast<int>(choice));
                return std::string();
              }
              names += (names.empty() ? "" : ", ") + name;
            }
            return "'" + text + "' is none of " + names;
          },
          ""};
}

}  // namespace lepp::cli
