#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lepp/io/text_file.hpp"

namespace lepp {

/// One of many equal things in a file: vertex 7.
struct Record {
  std::string_view kind;
  std::int64_t number = 0;
  std::string text() const { return std::string(kind) + " " + std::to_string(number); }
};

/// What a field holds, as messages call it: "x of vertex 7". It is put into words only when a
/// message needs them, so that a million vertices make no million texts.
class Label {
 public:
  Label(const char* words) : before_(words) {}
  Label(const std::string& words) : before_(words) {}
  Label(std::string_view before, const Record& record, std::string_view after = {})
      : before_(before), record_(record), after_(after) {}
  std::string text() const;

 private:
  std::string_view before_;  // of the caller, who outlives the label
  Record record_;            // no kind: none
  std::string_view after_;
};

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
  void need(const Label& what) {
    if (!next()) ends_before(what);
  }
  [[noreturn]] void ends_before(const Label& what);

  std::size_t fields() const { return fields_.size(); }
  std::string_view field(std::size_t i) const { return fields_[i]; }
  /// \throw InputError  `what` is missing on this line, or is not such a number.
  std::int64_t integer(std::size_t i, const Label& what) const {
    if (i < fields()) {
      if (const auto value = plain_integer(field(i))) return *value;
    }
    return integer_with_care(i, what);
  }
  /// A finite number. \throw InputError as above, and for nan, inf and numbers no double holds
  double number(std::size_t i, const Label& what) const;
  /// A coordinate in the supported range of pslg.hpp.
  double coordinate(std::size_t i, const Label& what) const;
  /// A count of records, each at least `least_bytes` long.
  /// \throw InputError  negative, or more records than the rest of the file can hold
  std::size_t count(std::size_t i, const Label& what, std::size_t least_bytes) const;
  /// \throw InputError  unless this line has `least` to `most` fields
  void expect_fields(std::size_t least, std::size_t most, const Label& meaning) const;

  const std::string& name() const { return name_; }
  /// "plate.poly, line 12"
  std::string where() const;
  [[noreturn]] void fail(std::string problem, std::string remedy) const;

 private:
  void read_fields();
  std::int64_t integer_with_care(std::size_t i, const Label& what) const;
  // A few digits and nothing else, as almost all integers are.
  static std::optional<std::int64_t> plain_integer(std::string_view text) {
    if (text.empty() || text.size() > 18) return std::nullopt;
    std::int64_t value = 0;
    for (const char c : text) {
      if (c < '0' || c > '9') return std::nullopt;
      value = 10 * value + (c - '0');
    }
    return value;
  }

  const std::string& name_;
  std::string_view text_;
  std::size_t at_ = 0;       // start of the next line
  std::int64_t line_ = 0;    // number of the current line
  std::int64_t passed_ = 0;  // lines before at_
  std::vector<std::string_view> fields_;
};

}  // namespace lepp
