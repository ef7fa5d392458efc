#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lepp {

/// An empty folder of our own among the temporary files, removed with all that is in it.
class PrivateFolder {
 public:
  /// \throw OutputError if it cannot be made
  PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  ~PrivateFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A program that reads files with a large library, so that lepp itself need not link it.
struct HelperProgram {
  std::string name;      ///< lepp-gmsh
  std::string variable;  ///< the environment variable that may name it
  std::string library;   ///< whose name messages use: Gmsh
  std::string package;   ///< what to install
};

/// The program: `given`; else what the environment variable names; else that name beside the
/// running program, or in ../libexec/lepp.
/// \throw InputError  that says how to install it
std::filesystem::path find_helper(const HelperProgram& helper,
                                  const std::optional<std::filesystem::path>& given);

/// What a helper is asked to do, and how long it may take.
struct HelperTask {
  HelperProgram helper;
  std::filesystem::path program;
  std::filesystem::path folder;  ///< for its temporary files
  std::vector<std::string> arguments;
  double seconds = 60;
  std::string time_remedy;                ///< what to do if that is not enough
  std::string display_name;               ///< what messages call the input
  std::function<bool()> keep_going = {};  ///< asked about once a second; false ends it
  /// Where it runs: in `folder`, or where the caller does, so that it finds what files name from
  /// there.
  enum class RunsIn { folder, callers_folder } runs_in = RunsIn::folder;
};

/// A helper at work, in a process group of its own, without input, output or environment but a pipe
/// that it writes to as descriptor 3. Destruction kills the group.
class Helper {
 public:
  /// \throw InputError  it cannot be started
  explicit Helper(HelperTask task);
  Helper(const Helper&) = delete;
  Helper& operator=(const Helper&) = delete;
  ~Helper();

  /// The next bytes that it wrote, at least one; 0 at the end.
  /// \throw RefusedError  time is up, or keep_going() said no
  std::size_t read(std::span<std::byte> bytes);
  /// Fills `bytes`. False if the end came first.
  bool read_all(std::span<std::byte> bytes);

  /// After the end of what it wrote, or in place of it: waits for its end, a second at most, and
  /// kills what is left of the group.
  /// \return  how it ended, as waitpid() says
  int finish();
  /// Throws about a helper that wrote no complete result: finish(), then what that means.
  [[noreturn]] void fail_without_result();

 private:
  void start(int write_end);
  void wait_until(std::chrono::steady_clock::time_point deadline) const;
  int kill();
  [[noreturn]] void out_of_time();

  HelperTask task_;
  std::chrono::steady_clock::time_point deadline_;
  int read_end_ = -1;
  pid_t process_ = -1;
};

}  // namespace lepp
