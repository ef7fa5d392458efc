#include "lepp/io/number_stream.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <limits>
#include <span>
#include <system_error>

#include "lepp/geometry/error.hpp"

namespace lepp {

namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 18;

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// At most 40 characters of it, for a message.
std::string quoted(std::string_view text) {
  std::string shown(text.substr(0, 40));
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = '?';
  }
  return "\"" + shown + (text.size() > 40 ? "...\"" : "\"");
}

}  // namespace

NumberStream::NumberStream(const InputFile& file, std::uint64_t offset, std::int64_t line)
    : file_(file), offset_(offset), line_(line), buffer_(buffer_size) {
  at_ = word_ = end_ = buffer_.data();
}

// Moves what is not read yet to the front and fills up. False if nothing more came.
bool NumberStream::refill() {
  const auto kept = static_cast<std::size_t>(end_ - at_);
  std::memmove(buffer_.data(), at_, kept);
  const std::span<char> free = std::span(buffer_).subspan(kept);
  const std::size_t n = file_.read(offset_, std::as_writable_bytes(free));
  offset_ += n;
  at_ = buffer_.data();
  end_ = at_ + kept + n;
  return n != 0;
}

bool NumberStream::next(std::string_view& word) {
  while (true) {
    for (; at_ != end_ && is_blank(*at_); ++at_) line_ += *at_ == '\n';
    if (at_ != end_) break;
    if (!refill()) return false;
  }
  const char* c = std::find_if(at_, end_, is_blank);
  if (c == end_) {
    const auto length = c - at_;
    refill();
    c = std::find_if(at_ + length, end_, is_blank);
    if (c == end_ && c - at_ == static_cast<std::ptrdiff_t>(buffer_size)) {
      throw InputError(where(), "a word of more than " + std::to_string(buffer_size) + " bytes",
                       "the file is damaged or no text: export it again");
    }
  }
  word = {at_, static_cast<std::size_t>(c - at_)};
  word_ = at_;
  at_ = c;
  return true;
}

void NumberStream::skip_line() {
  while (true) {
    at_ = std::find(at_, end_, '\n');
    if (at_ != end_ || !refill()) return;
  }
}

std::uint64_t NumberStream::bytes_left() const {
  const std::uint64_t passed = offset_ - static_cast<std::uint64_t>(end_ - word_);
  return file_.size() - std::min(file_.size(), passed);
}

double NumberStream::number(std::string_view word) const {
  double value = 0;
  const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end == digits.data() + digits.size()) {
    if (error == std::errc()) return value;
    // from_chars leaves open whether it is too large or too small.
    const bool tiny = digits.find("e-") != digits.npos || digits.find("E-") != digits.npos;
    if (error == std::errc::result_out_of_range)
      return tiny ? 0 : std::numeric_limits<double>::infinity();
  }
  throw InputError(where(), quoted(word) + " is not a number",
                   word.find(',') != word.npos ? "use a decimal point, as in 1.5, and blanks"
                                               : "correct the line, or export the file again");
}

}  // namespace lepp
