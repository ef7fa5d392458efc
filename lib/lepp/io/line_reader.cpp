#include "lepp/io/line_reader.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include "lepp/geometry/error.hpp"
#include "lepp/geometry/pslg.hpp"
#include "lepp/geometry/text.hpp"

namespace lepp {

namespace {

// What a character means, in a table: one step per character for lines, comments and fields alike.
enum class Kind : std::uint8_t { text, blank, comment, line_end };

constexpr std::array<Kind, 256> kinds = [] {
  std::array<Kind, 256> table{};
  for (const char c : {' ', '\t', '\v', '\f'}) table[static_cast<unsigned char>(c)] = Kind::blank;
  table['#'] = Kind::comment;
  table['\r'] = table['\n'] = Kind::line_end;
  return table;
}();

Kind kind_of(char c) { return kinds[static_cast<unsigned char>(c)]; }
bool is_line_end(char c) { return kind_of(c) == Kind::line_end; }

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

// Numbers of other countries and languages: 1,5 and 1.5D0.
const char* remedy_for_number(std::string_view text) {
  const bool has_digit = text.find_first_of("0123456789") != std::string_view::npos;
  const bool is_plain = text.find_first_not_of("0123456789+-.,eEdD") == std::string_view::npos;
  if (!has_digit || !is_plain) return "correct the line";
  if (text.find(',') != std::string_view::npos) return "use a decimal point, as in 1.5";
  if (text.find_first_of("dD") != std::string_view::npos)
    return "write exponents with e, as in 1.5e0";
  return "correct the line";
}

}  // namespace

std::string Label::text() const {
  std::string words(before_);
  if (!record_.kind.empty()) words += record_.text();
  return words.append(after_);
}

bool LineReader::next() {
  fields_.clear();
  while (at_ < text_.size()) {
    line_ = ++passed_;
    read_fields();
    if (!fields_.empty()) return true;
  }
  return false;
}

// Takes the fields of the line that starts at at_, and goes behind its end.
void LineReader::read_fields() {
  const char* const end = text_.data() + text_.size();
  const char* c = text_.data() + at_;
  for (; c != end; ++c) {
    if (kind_of(*c) == Kind::text) {
      const char* const start = c;
      while (c != end && kind_of(*c) == Kind::text) ++c;
      fields_.emplace_back(start, static_cast<std::size_t>(c - start));
      if (c == end) break;
    }
    if (kind_of(*c) == Kind::comment) c = std::find_if(c, end, is_line_end);
    if (c == end || kind_of(*c) == Kind::line_end) break;
  }
  const bool two = end - c > 1 && c[0] == '\r' && c[1] == '\n';
  at_ = static_cast<std::size_t>(c - text_.data()) + (two ? 2 : 1);
}

void LineReader::ends_before(const Label& what) {
  line_ = passed_;
  fail("the file ends where " + what.text() + " should be",
       "the file is cut short: export it again");
}

std::int64_t LineReader::integer_with_care(std::size_t i, const Label& what) const {
  if (i >= fields()) fail(what.text() + " is missing", "add it to the line");
  const std::string_view text = without_plus(field(i));
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    fail(what.text() + " is " + quoted(field(i)) + ", which is not a whole number",
         "correct the line");
  }
  return value;
}

double LineReader::number(std::size_t i, const Label& what) const {
  if (i >= fields()) fail(what.text() + " is missing", "add it to the line");
  const std::string_view text = without_plus(field(i));
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) {
    fail(what.text() + " is " + quoted(field(i)) + ", too large or too small for a double",
         "choose another unit of length");
  }
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    fail(what.text() + " is " + quoted(field(i)) + ", which is not a finite number",
         remedy_for_number(field(i)));
  }
  return value;
}

double LineReader::coordinate(std::size_t i, const Label& what) const {
  const double value = number(i, what);
  const double size = std::abs(value);
  if (size != 0 && (size < min_coordinate || size > max_coordinate)) {
    fail(what.text() + " is " + quoted(field(i)) + ", outside the supported range of magnitudes, " +
             to_text(min_coordinate) + " to " + to_text(max_coordinate) + " (and 0)",
         "choose another unit of length");
  }
  return value;
}

std::size_t LineReader::count(std::size_t i, const Label& what, std::size_t least_bytes) const {
  const std::int64_t value = integer(i, "the number of " + what.text());
  if (value < 0) {
    fail("the number of " + what.text() + " is " + std::to_string(value), "correct the line");
  }
  // The last line may lack its line end.
  const std::size_t left = text_.size() - std::min(at_, text_.size()) + 1;
  if (static_cast<std::uint64_t>(value) > left / least_bytes) {
    fail("announces " + std::to_string(value) + " " + what.text() +
             ", more than the rest of the file can hold",
         "correct the number, or the file is cut short: export it again");
  }
  return static_cast<std::size_t>(value);
}

void LineReader::expect_fields(std::size_t least, std::size_t most, const Label& meaning) const {
  if (fields() >= least && fields() <= most) return;
  const std::string wanted =
      least == most ? std::to_string(least) : std::to_string(least) + " to " + std::to_string(most);
  fail("has " + std::to_string(fields()) + " fields where " + wanted + " belong: " + meaning.text(),
       "correct the line, or the header above it");
}

std::string LineReader::where() const { return name_ + ", line " + std::to_string(line_); }

void LineReader::fail(std::string problem, std::string remedy) const {
  throw InputError(where(), std::move(problem), std::move(remedy));
}

}  // namespace lepp
