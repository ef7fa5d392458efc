#include "lepp/io/number_stream.hpp"

#include <algorithm>
#include <cstring>
#include <span>

#include "lepp/geometry/error.hpp"
#include "lepp/io/number_word.hpp"

namespace lepp {

namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 18;

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

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
  return file_.size() - std::min(file_.size(), offset());
}

double NumberStream::number(std::string_view word) const {
  if (const auto value = number_of(word)) return *value;
  throw InputError(where(), quoted(word) + " is not a number",
                   word.find(',') != word.npos ? "use a decimal point, as in 1.5, and blanks"
                                               : "correct the line, or export the file again");
}

}  // namespace lepp
