#include "lepp/io/input_file.hpp"

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

[[noreturn]] void cannot(std::string_view doing, const std::string& name, int error) {
  throw InputError(name,
                   "cannot " + std::string(doing) + ": " + std::generic_category().message(error),
                   error == ENOENT ? "correct the file's name" : "give a file that you may read");
}

}  // namespace

InputFile::InputFile(const std::filesystem::path& path)
    : name_(path.string()), descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
  if (descriptor_ < 0) cannot("open", name_, errno);
  struct stat status {};
  const int error = ::fstat(descriptor_, &status) != 0 ? errno : 0;
  if (error == 0 && S_ISREG(status.st_mode)) {
    size_ = static_cast<std::uint64_t>(status.st_size);
    return;
  }
  ::close(descriptor_);
  if (error != 0) cannot("open", name_, error);
  throw InputError(name_,
                   S_ISDIR(status.st_mode) ? "is a folder, not a file" : "is a device, not a file",
                   "give the name of a file");
}

InputFile::~InputFile() { ::close(descriptor_); }

std::size_t InputFile::read(std::uint64_t offset, std::span<std::byte> bytes) const {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t n = ::pread(descriptor_, bytes.data() + done, bytes.size() - done,
                              static_cast<off_t>(offset + done));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) cannot("read", name_, errno);
    if (n == 0) break;
    done += static_cast<std::size_t>(n);
  }
  return done;
}

void InputFile::read_all(std::uint64_t offset, std::span<std::byte> bytes) const {
  if (read(offset, bytes) == bytes.size()) return;
  throw InputError(name_, "the file is cut short", "export it again");
}

std::string InputFile::head(std::size_t most) const {
  std::string text(static_cast<std::size_t>(std::min<std::uint64_t>(most, size_)), '\0');
  text.resize(read(0, std::as_writable_bytes(std::span(text))));
  return text;
}

}  // namespace lepp
