#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>

namespace lepp {

/// A place in the bytes of a .msh file, text or binary, that never goes beyond them.
/// Every error is an InputError that names the file and the line.
class MeshCursor {
 public:
  /// \pre `bytes` outlives the cursor
  MeshCursor(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

  bool at_end() const { return at_ >= bytes_.size(); }
  std::size_t position() const { return at_; }
  void go_to(std::size_t position) { at_ = position; }

  /// The next line without blanks around it.
  std::string_view line();
  /// The next line that is not blank. An error if the section or the file ends before `what`.
  std::string_view data_line(std::string_view what);
  /// Takes a number off the front of a line.
  template <class Number>
  Number number(std::string_view& line, std::string_view what) const {
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), value);
    if (error != std::errc()) fail(std::string(what) + " is not a number");
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    return value;
  }
  /// Goes behind `count` words; how they are spread over lines does not matter.
  void skip_words(std::uint64_t count, std::string_view what);
  /// Goes behind the line that starts with `mark`.
  void skip_past(std::string_view mark);

  /// A number as its bytes lie in the file, in the other order if `swapped`.
  template <class Number>
  Number binary(bool swapped) {
    std::array<char, sizeof(Number)> raw{};
    checked_count(raw.size(), "bytes", 1);
    std::memcpy(raw.data(), bytes_.data() + at_, raw.size());
    if (swapped) std::reverse(raw.begin(), raw.end());
    at_ += raw.size();
    Number value{};
    std::memcpy(&value, raw.data(), raw.size());
    return value;
  }
  /// Goes behind `count` records of `bytes_each` bytes.
  void skip_bytes(std::uint64_t count, std::uint64_t bytes_each, std::string_view what);

  /// A count of records of at least `least_bytes` each, checked against what is left of the file.
  std::uint64_t checked_count(std::uint64_t count, std::string_view what,
                              std::uint64_t least_bytes) const;

  [[noreturn]] void fail(const std::string& problem,
                         const std::string& remedy = "write the mesh again, or correct it") const;
  const std::string& name() const { return name_; }

 private:
  std::string_view bytes_;
  std::string name_;
  std::size_t at_ = 0, line_start_ = 0;
};

}  // namespace lepp
