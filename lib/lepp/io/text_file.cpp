#include "lepp/io/text_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string_view>
#include <system_error>

#include "lepp/geometry/error.hpp"

namespace lepp {

namespace {

class Descriptor {
 public:
  explicit Descriptor(const std::filesystem::path& path)
      : value_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  operator int() const { return value_; }

 private:
  int value_;
};

[[noreturn]] void cannot(std::string_view doing, const std::string& name, int error) {
  throw InputError(name,
                   "cannot " + std::string(doing) + ": " + std::generic_category().message(error),
                   error == ENOENT ? "correct the file's name" : "give a file that you may read");
}

std::string read_all(int descriptor, const std::string& name, std::size_t size) {
  std::string text(size, '\0');
  std::size_t done = 0;
  while (done < size) {
    const ssize_t n = ::read(descriptor, text.data() + done, size - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) cannot("read", name, errno);
    if (n == 0) break;  // shorter than it was a moment ago
    done += static_cast<std::size_t>(n);
  }
  text.resize(done);
  return text;
}

void check_text(const std::string& name, std::string_view text) {
  if (text.empty()) throw InputError(name, "the file is empty", "give a file with data");
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    throw InputError(name + ", line 1", "the file is UTF-16 text",
                     "save it as plain text or UTF-8");
  }
  const auto nul = text.find('\0');
  if (nul == std::string_view::npos) return;
  const auto line = 1 + std::ranges::count(text.substr(0, nul), '\n');
  throw InputError(name + ", line " + std::to_string(line), "a NUL byte in a text file",
                   "the file is binary or damaged: export it again as text");
}

}  // namespace

TextFile read_text_file(const std::filesystem::path& path, std::uint64_t size_limit) {
  TextFile file{path.string(), {}};
  const Descriptor descriptor(path);
  if (descriptor < 0) cannot("open", file.name, errno);
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) cannot("open", file.name, errno);
  if (!S_ISREG(status.st_mode)) {
    throw InputError(
        file.name, S_ISDIR(status.st_mode) ? "is a folder, not a file" : "is a device, not a file",
        "give the name of a file");
  }
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size > size_limit) {
    throw RefusedError(
        file.name,
        "has " + std::to_string(size) + " bytes, the limit is " + std::to_string(size_limit),
        "split the input");
  }
  file.text = read_all(descriptor, file.name, static_cast<std::size_t>(size));
  check_text(file.name, file.text);
  if (file.text.starts_with("\xEF\xBB\xBF")) file.text.erase(0, 3);
  return file;
}

}  // namespace lepp
