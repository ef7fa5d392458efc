#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lepp/io/text_file.hpp"

namespace lepp {

/// Walks through the lines of a text file that have fields on them. Fields are separated by spaces
/// and tabs; '#' starts a comment; lines end with LF, CRLF or CR.
/// Every error names the file and the line.
class LineReader {
 public:
  /// `file` must outlive the reader.
  explicit LineReader(const TextFile& file) : name_(file.name), text_(file.text) {}

  /// Goes to the next line with a field. False at the end of the file.
  bool next();
  /// The same, where the file must go on. \throw InputError saying that `what` is missing
  void need(std::string_view what);

  std::size_t fields() const { return fields_.size(); }
  std::string_view field(std::size_t i) const { return fields_[i]; }
  /// \throw InputError  `what` is missing on this line, or is not such a number.
  std::int64_t integer(std::size_t i, std::string_view what) const;
  /// A finite number. \throw InputError as above, and for nan, inf and numbers no double holds
  double number(std::size_t i, std::string_view what) const;
  /// A coordinate in the supported range of pslg.hpp.
  double coordinate(std::size_t i, std::string_view what) const;
  /// A count of records, each at least `least_bytes` long.
  /// \throw InputError  negative, or more records than the rest of the file can hold
  std::size_t count(std::size_t i, std::string_view what, std::size_t least_bytes) const;
  /// \throw InputError  unless this line has `least` to `most` fields
  void expect_fields(std::size_t least, std::size_t most, std::string_view meaning) const;

  const std::string& name() const { return name_; }
  /// "plate.poly, line 12"
  std::string where() const;
  [[noreturn]] void fail(std::string problem, std::string remedy) const;

 private:
  const std::string& name_;
  std::string_view text_;
  std::size_t at_ = 0;       // start of the next line
  std::int64_t line_ = 0;    // number of the current line
  std::int64_t passed_ = 0;  // lines before at_
  std::vector<std::string_view> fields_;
};

}  // namespace lepp
