#include "lepp/io/line_reader.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/pslg.hpp"
#include "lepp/geometry/text.hpp"

namespace lepp {

namespace {

constexpr std::string_view blanks = " \t\v\f";

// from_chars knows no plus sign.
std::string_view without_plus(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  return text;
}

// At most 40 characters of it, for a message.
std::string quoted(std::string_view text) {
  std::string shown(text.substr(0, 40));
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < ' ') c = '?';
  }
  return "\"" + shown + (text.size() > 40 ? "...\"" : "\"");
}

}  // namespace

bool LineReader::next() {
  while (at_ < text_.size()) {
    const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    std::string_view line = text_.substr(at_, end - at_);
    at_ = text_.substr(end).starts_with("\r\n") ? end + 2 : end + 1;
    line_ = ++passed_;
    line = line.substr(0, line.find('#'));
    fields_.clear();
    for (std::size_t i = line.find_first_not_of(blanks); i < line.size();) {
      const std::size_t stop = std::min(line.find_first_of(blanks, i), line.size());
      fields_.push_back(line.substr(i, stop - i));
      i = line.find_first_not_of(blanks, stop);
    }
    if (!fields_.empty()) return true;
  }
  fields_.clear();
  return false;
}

void LineReader::need(std::string_view what) {
  if (next()) return;
  line_ = passed_;
  fail("the file ends where " + std::string(what) + " should be",
       "the file is cut short: export it again");
}

std::int64_t LineReader::integer(std::size_t i, std::string_view what) const {
  if (i >= fields()) fail(std::string(what) + " is missing", "add it to the line");
  const std::string_view text = without_plus(field(i));
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    fail(std::string(what) + " is " + quoted(field(i)) + ", which is not a whole number",
         "correct the line");
  }
  return value;
}

double LineReader::number(std::size_t i, std::string_view what) const {
  if (i >= fields()) fail(std::string(what) + " is missing", "add it to the line");
  const std::string_view text = without_plus(field(i));
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) {
    fail(std::string(what) + " is " + quoted(field(i)) + ", too large or too small for a double",
         "choose another unit of length");
  }
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    fail(std::string(what) + " is " + quoted(field(i)) + ", which is not a finite number",
         "correct the line");
  }
  return value;
}

double LineReader::coordinate(std::size_t i, std::string_view what) const {
  const double value = number(i, what);
  const double size = std::abs(value);
  if (size != 0 && (size < min_coordinate || size > max_coordinate)) {
    fail(std::string(what) + " is " + quoted(field(i)) +
             ", outside the supported range of magnitudes, " + to_text(min_coordinate) + " to " +
             to_text(max_coordinate) + " (and 0)",
         "choose another unit of length");
  }
  return value;
}

std::size_t LineReader::count(std::size_t i, std::string_view what, std::size_t least_bytes) const {
  const std::int64_t value = integer(i, "the number of " + std::string(what));
  if (value < 0) {
    fail("the number of " + std::string(what) + " is " + std::to_string(value), "correct the line");
  }
  // The last line may lack its line end.
  const std::size_t left = text_.size() - std::min(at_, text_.size()) + 1;
  if (static_cast<std::uint64_t>(value) > left / least_bytes) {
    fail("announces " + std::to_string(value) + " " + std::string(what) +
             ", more than the rest of the file can hold",
         "correct the number, or the file is cut short: export it again");
  }
  return static_cast<std::size_t>(value);
}

void LineReader::expect_fields(std::size_t least, std::size_t most,
                               std::string_view meaning) const {
  if (fields() >= least && fields() <= most) return;
  const std::string wanted =
      least == most ? std::to_string(least) : std::to_string(least) + " to " + std::to_string(most);
  fail("has " + std::to_string(fields()) + " fields where " + wanted +
           " belong: " + std::string(meaning),
       "correct the line, or the header above it");
}

std::string LineReader::where() const { return name_ + ", line " + std::to_string(line_); }

void LineReader::fail(std::string problem, std::string remedy) const {
  throw InputError(where(), std::move(problem), std::move(remedy));
}

}  // namespace lepp
