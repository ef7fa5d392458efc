#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace lepp {

/// A regular file that is open for reading, at any place.
class InputFile {
 public:
  /// \throw InputError  no such file, a folder or a device
  explicit InputFile(const std::filesystem::path& path);
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile();

  const std::string& name() const { return name_; }  ///< as the caller wrote it, for messages
  std::uint64_t size() const { return size_; }

  /// Fills `bytes` from `offset` on.
  /// \return  how many there were before the end of the file
  /// \throw   InputError  the disk does not give them
  std::size_t read(std::uint64_t offset, std::span<std::byte> bytes) const;
  /// The same where all of them must be there. \throw InputError  the file got shorter meanwhile
  void read_all(std::uint64_t offset, std::span<std::byte> bytes) const;
  /// The first bytes as text, no more than `most`.
  std::string head(std::size_t most) const;

 private:
  std::string name_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace lepp
