#pragma once

#include <charconv>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace lepp {

/// A file being written, through a buffer of a megabyte. Numbers are written by to_chars, doubles
/// in the shortest form that reads back as the same double; no locale is asked.
/// AtomicFiles makes it, and gives it its name.
class OutputFile {
 public:
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// \throw OutputError  when the buffer cannot be written: disk full, size limit, ...
  OutputFile& operator<<(std::string_view text);
  OutputFile& operator<<(char c) {
    *room_for(1) = c;
    ++used_;
    return *this;
  }
  OutputFile& operator<<(double number);
  OutputFile& operator<<(std::integral auto number) {
    char* const start = room_for(longest_integer);
    used_ +=
        static_cast<std::size_t>(std::to_chars(start, start + longest_integer, number).ptr - start);
    return *this;
  }
  /// A number with `decimals` digits after the point, for pictures.
  OutputFile& fixed(double number, int decimals);

 private:
  friend class AtomicFiles;
  explicit OutputFile(const std::filesystem::path& target);

  void open_temporary();
  void open_device();
  void flush();
  // Where to put up to `size` characters, size <= buffer_size.
  char* room_for(std::size_t size) {
    if (buffer_size - used_ < size) flush();
    return buffer_.get() + used_;
  }
  void close();        // flush, fsync, close; once
  void keep_old();     // gives the old file a second name
  void rename();       // temporary to target
  void restore_old();  // undoes rename()
  void remove_temporaries();
  [[noreturn]] void fail(std::string_view doing, int error) const;

  std::string name_;              // as the caller wrote it, for messages
  std::filesystem::path target_;  // symbolic links resolved
  std::filesystem::path temporary_, old_;
  static constexpr std::size_t buffer_size = std::size_t{1} << 20;
  static constexpr std::size_t longest_integer = 20;  // -9223372036854775808
  std::unique_ptr<char[]> buffer_;
  std::size_t used_ = 0;  // of the buffer
  int descriptor_ = -1;
};

/// A set of files that appear together, complete, or not at all.
///
/// Each is written to a temporary file beside its target. commit() writes out the buffers, fsyncs
/// and closes every file, checks all of it, and only then renames. Whatever fails before, during or
/// instead of commit(): no temporary is left and the old files are as they were. (A file system
/// without hard links cannot bring back the first old files of a set when a later rename fails.)
/// A target that is a device, a terminal or a pipe is written to directly. Whether an existing file
/// may be replaced is the caller's question.
/// A process with a limit on file size should ignore SIGXFSZ; then the limit is an OutputError.
class AtomicFiles {
 public:
  AtomicFiles() = default;
  AtomicFiles(const AtomicFiles&) = delete;
  AtomicFiles& operator=(const AtomicFiles&) = delete;
  ~AtomicFiles();

  /// Starts the temporary file of `target`; the result lives as long as the set.
  /// \throw OutputError  no such folder, no permission, the target is a folder, ...
  OutputFile& add(const std::filesystem::path& target);

  /// Writes all files out under their temporary names, after which they are complete and only
  /// commit() is left to do: for a set that goes with files of others.
  /// \throw OutputError  naming the file and what the system said
  void prepare();

  /// prepare(), and gives the files their names. \throw OutputError  likewise
  void commit();

 private:
  std::vector<std::unique_ptr<OutputFile>> files_;
};

}  // namespace lepp
