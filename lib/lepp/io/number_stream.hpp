#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lepp/io/input_file.hpp"

namespace lepp {

/// The words of a text file, one after the other, in little memory whatever the length of the file.
class NumberStream {
 public:
  explicit NumberStream(const InputFile& file, std::uint64_t offset = 0, std::int64_t line = 1);

  /// The next word, until the next call; false at the end of the file.
  bool next(std::string_view& word);
  /// The last word comes again.
  void put_back() { at_ = word_; }
  /// Passes what is left of the line: a comment.
  void skip_line();
  /// Of the last word, from 1 on.
  std::int64_t line() const { return line_; }
  /// Of the last word, in the file.
  std::uint64_t offset() const { return offset_ - static_cast<std::uint64_t>(end_ - word_); }
  /// Bytes from the last word to the end of the file.
  std::uint64_t bytes_left() const;

  /// The number that a word is, which may be NaN or an infinity. \throw InputError  it is none
  double number(std::string_view word) const;
  /// "dem.asc, line 7"
  std::string where() const { return file_.name() + ", line " + std::to_string(line_); }

 private:
  bool refill();

  const InputFile& file_;
  std::uint64_t offset_;  // of the byte behind the buffer
  std::int64_t line_;
  std::vector<char> buffer_;
  const char* at_ = nullptr;
  const char* word_ = nullptr;
  const char* end_ = nullptr;
};

}  // namespace lepp
