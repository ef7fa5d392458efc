#include "lepp/io/atomic_files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <optional>
#include <system_error>
#include <utility>

#include "lepp/geometry/error.hpp"

namespace lepp {

namespace {

namespace fs = std::filesystem;

std::string remedy_for(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return "free some space or write to another disk";
    case EFBIG:
      return "raise the limit on file size (ulimit -f) or ask for a coarser mesh";
    case ENOENT:
    case ENOTDIR:
      return "make the folder first, or correct the path";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a place you may write to";
    case EISDIR:
      return "give the name of a file";
    default:
      return "choose another place, or look at the disk";
  }
}

// The file that a chain of symbolic links ends at, whether or not it exists.
fs::path follow_links(fs::path path) {
  for (int hops = 0; hops < 40; ++hops) {
    std::error_code none;
    if (!fs::is_symlink(path, none)) break;
    const fs::path to = fs::read_symlink(path, none);
    path = to.is_absolute() ? to : path.parent_path() / to;
  }
  return path;
}

std::optional<struct stat> status_of(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return status;
}

// A name beside `target` that nobody uses: .name.123-0.tmp
fs::path hidden_name(const fs::path& target, int attempt) {
  const std::string stem = target.filename().string().substr(0, 200);
  const std::string name =
      "." + stem + "." + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp";
  return target.parent_path() / name;
}

void sync_folder(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;  // the rename has happened; a folder that cannot be synced is no loss
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

OutputFile::OutputFile(const fs::path& target)
    : name_(target.string()),
      target_(follow_links(target)),
      buffer_(std::make_unique_for_overwrite<char[]>(buffer_size)) {
  const auto status = status_of(target_);
  if (target_.filename().empty() || (status && S_ISDIR(status->st_mode))) fail("open", EISDIR);
  if (status && ::access(target_.c_str(), W_OK) != 0) fail("replace", errno);
  if (status && !S_ISREG(status->st_mode)) open_device();
  else open_temporary();
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  remove_temporaries();
}

void OutputFile::open_temporary() {
  const auto old = status_of(target_);
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const fs::path name = hidden_name(target_, attempt);
    descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno == EEXIST) continue;
    if (descriptor_ < 0) fail("make a file there", errno);
    temporary_ = name;
    if (old && ::fchmod(descriptor_, old->st_mode & 07777) != 0) {
      const int error = errno;
      ::close(std::exchange(descriptor_, -1));
      remove_temporaries();
      fail("keep the permissions of the old file", error);
    }
    return;
  }
  fail("find a name for a temporary file", EEXIST);
}

void OutputFile::open_device() {
  descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor_ < 0) fail("open", errno);
}

OutputFile& OutputFile::operator<<(std::string_view text) {
  while (!text.empty()) {
    const std::string_view part = text.substr(0, buffer_size);
    part.copy(room_for(part.size()), part.size());
    used_ += part.size();
    text.remove_prefix(part.size());
  }
  return *this;
}

OutputFile& OutputFile::operator<<(double number) {
  constexpr std::size_t longest = 32;  // the longest double has 24 characters
  char* const start = room_for(longest);
  used_ += static_cast<std::size_t>(std::to_chars(start, start + longest, number).ptr - start);
  return *this;
}

OutputFile& OutputFile::fixed(double number, int decimals) {
  constexpr std::size_t longest = 400;  // 1e308 has 309 digits
  char* const start = room_for(longest);
  const auto end =
      std::to_chars(start, start + longest, number, std::chars_format::fixed, decimals).ptr;
  used_ += static_cast<std::size_t>(end - start);
  return *this;
}

void OutputFile::flush() {
  std::size_t done = 0;
  while (done < used_) {
    const ssize_t n = ::write(descriptor_, buffer_.get() + done, used_ - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail("write", errno);
    done += static_cast<std::size_t>(n);
  }
  used_ = 0;
}

void OutputFile::close() {
  if (descriptor_ < 0) return;
  flush();
  if (!temporary_.empty() && ::fsync(descriptor_) != 0) fail("write to the disk", errno);
  const int descriptor = std::exchange(descriptor_, -1);
  if (::close(descriptor) != 0) fail("close", errno);
}

void OutputFile::keep_old() {
  if (temporary_.empty()) return;
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const fs::path name = hidden_name(target_, attempt);
    if (::link(target_.c_str(), name.c_str()) == 0) old_ = name;
    else if (errno == EEXIST) continue;
    return;  // no old file, or no hard links here: nothing to bring back
  }
}

void OutputFile::rename() {
  if (temporary_.empty()) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail("replace the old file", errno);
  temporary_.clear();
}

void OutputFile::restore_old() {
  if (!old_.empty()) ::rename(old_.c_str(), target_.c_str());
  else ::unlink(target_.c_str());
  old_.clear();
}

void OutputFile::remove_temporaries() {
  for (const fs::path* path : {&temporary_, &old_}) {
    if (!path->empty()) ::unlink(path->c_str());
  }
  temporary_.clear();
  old_.clear();
}

void OutputFile::fail(std::string_view doing, int error) const {
  throw OutputError(name_,
                    "cannot " + std::string(doing) + ": " + std::generic_category().message(error),
                    remedy_for(error));
}

AtomicFiles::~AtomicFiles() = default;

OutputFile& AtomicFiles::add(const fs::path& target) {
  files_.push_back(std::unique_ptr<OutputFile>(new OutputFile(target)));
  return *files_.back();
}

void AtomicFiles::prepare() {
  for (const auto& file : files_) file->close();
}

void AtomicFiles::commit() {
  prepare();
  if (files_.size() > 1) {
    for (const auto& file : files_) file->keep_old();
  }
  std::size_t renamed = 0;
  try {
    for (; renamed < files_.size(); ++renamed) files_[renamed]->rename();
  } catch (const OutputError&) {
    while (renamed > 0) files_[--renamed]->restore_old();
    files_.clear();
    throw;
  }
  for (const auto& file : files_) sync_folder(file->target_);
  files_.clear();
}

}  // namespace lepp
