#include "lepp/io/header_words.hpp"

#include <charconv>

#include "lepp/geometry/error.hpp"

namespace lepp {

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view blanks = " \t\r\v\f";
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(blanks); at != line.npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(blanks, end);
  }
  return words;
}

double header_number(const InputFile& file, std::string_view word) {
  double value = 0;
  const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc() && end == digits.data() + digits.size()) return value;
  throw InputError(file.name() + ", header",
                   "\"" + std::string(word.substr(0, 40)) + "\" is not a number",
                   "correct the header");
}

}  // namespace lepp
