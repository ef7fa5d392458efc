#pragma once

#include <string_view>
#include <vector>

#include "lepp/io/input_file.hpp"

namespace lepp {

/// The words of a line, separated by blanks.
std::vector<std::string_view> words_of(std::string_view line);

/// \throw InputError  the word of the file's header is no number; "nan" is one
double header_number(const InputFile& file, std::string_view word);

}  // namespace lepp
