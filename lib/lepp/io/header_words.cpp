#include "lepp/io/header_words.hpp"

#include <algorithm>

#include "lepp/geometry/error.hpp"
#include "lepp/io/number_word.hpp"

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
  if (const auto value = number_of(word)) return *value;
  throw InputError(file.name() + ", header", quoted(word) + " is not a number",
                   "correct the header");
}

}  // namespace lepp
