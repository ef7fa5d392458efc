#include "stress/save_case.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <string_view>

namespace lepp::test {

namespace {

class Output {
 public:
  explicit Output(const char* path) : file_(open(path, O_WRONLY | O_CREAT | O_TRUNC, 0644)) {
    good_ = file_ >= 0;
  }
  ~Output() {
    flush();
    if (file_ >= 0) close(file_);
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  Output& operator<<(std::string_view text) {
    for (const char c : text) {
      if (used_ == buffer_.size()) flush();
      buffer_[used_++] = c;
    }
    return *this;
  }
  template <class Number>
  requires std::is_arithmetic_v<Number> Output& operator<<(Number value) {
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return *this << std::string_view(text.data(), static_cast<std::size_t>(end - text.data()));
  }
  bool flush() {
    std::size_t written = 0;
    while (good_ && written < used_) {
      const ssize_t n = write(file_, buffer_.data() + written, used_ - written);
      good_ = n > 0;
      if (good_) written += static_cast<std::size_t>(n);
    }
    used_ = 0;
    return good_;
  }

 private:
  int file_;
  bool good_ = false;
  std::array<char, 4096> buffer_{};
  std::size_t used_ = 0;
};

}  // namespace

bool save_case(const Pslg& pslg, const char* path) noexcept {
  Output out(path);
  out << pslg.points.size() << " 2 0 0\n";
  for (std::size_t i = 0; i < pslg.points.size(); ++i) {
    out << i << " " << pslg.points[i].x << " " << pslg.points[i].y << "\n";
  }
  out << pslg.segments.size() << " 1\n";
  for (std::size_t i = 0; i < pslg.segments.size(); ++i) {
    const Segment& s = pslg.segments[i];
    out << i << " " << s.a.value << " " << s.b.value << " " << (s.curve ? s.curve->value + 1 : 0)
        << "\n";
  }
  out << pslg.holes.size() << "\n";
  for (std::size_t i = 0; i < pslg.holes.size(); ++i) {
    out << i << " " << pslg.holes[i].x << " " << pslg.holes[i].y << "\n";
  }
  out << pslg.seeds.size() << "\n";
  for (std::size_t i = 0; i < pslg.seeds.size(); ++i) {
    const RegionSeed& s = pslg.seeds[i];
    out << i << " " << s.at.x << " " << s.at.y << " " << s.surface.value + 1 << "\n";
  }
  return out.flush();
}

}  // namespace lepp::test
