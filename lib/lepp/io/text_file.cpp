#include "lepp/io/text_file.hpp"

#include <algorithm>
#include <span>
#include <string_view>

#include "lepp/geometry/error.hpp"
#include "lepp/io/input_file.hpp"

namespace lepp {

namespace {

void check_text(const std::string& name, std::string_view text) {
  if (text.empty()) throw InputError(name, "the file is empty", "give a file with data");
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    throw InputError(name + ", line 1", "the file is UTF-16 text",
                     "save it as plain text or UTF-8");
  }
  const auto nul = text.find('\0');
  if (nul == std::string_view::npos) return;
  const auto line = 1 + std::ranges::count(text.substr(0, nul), '\n');
  throw InputError(name + ", line " + std::to_string(line), "a NUL byte in a text file",
                   "the file is binary or damaged: export it again as text");
}

}  // namespace

TextFile read_text_file(const std::filesystem::path& path, std::uint64_t size_limit) {
  const InputFile input(path);
  if (input.size() > size_limit) {
    throw RefusedError(input.name(),
                       "has " + std::to_string(input.size()) + " bytes, the limit is " +
                           std::to_string(size_limit),
                       "split the input");
  }
  TextFile file{input.name(), std::string(static_cast<std::size_t>(input.size()), '\0')};
  file.text.resize(input.read(0, std::as_writable_bytes(std::span(file.text))));
  check_text(file.name, file.text);
  if (file.text.starts_with("\xEF\xBB\xBF")) file.text.erase(0, 3);
  return file;
}

}  // namespace lepp
