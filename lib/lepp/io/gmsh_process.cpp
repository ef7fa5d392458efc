#include "lepp/io/gmsh_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <system_error>
#include <utility>

#include "lepp/geometry/error.hpp"

namespace lepp {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

std::string message_of(int error) { return std::generic_category().message(error); }

class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  int value() const { return value_; }
  void close() {
    if (value_ >= 0) ::close(value_);
    value_ = -1;
  }

 private:
  int value_;
};

/// The two attribute objects of posix_spawn.
struct SpawnSetup {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;

  SpawnSetup() {
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
  }
  SpawnSetup(const SpawnSetup&) = delete;
  SpawnSetup& operator=(const SpawnSetup&) = delete;
  ~SpawnSetup() {
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
  }
};

constexpr int record_descriptor = 3;  // where the helper writes, inherited

/// The helper in a process group of its own. Destruction kills the group.
class Helper {
 public:
  Helper(const fs::path& program, const fs::path& folder, std::vector<std::string> arguments,
         int write_end) {
    SpawnSetup setup;
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
      posix_spawn_file_actions_addopen(&setup.actions, stream, "/dev/null", O_RDWR, 0);
    posix_spawn_file_actions_adddup2(&setup.actions, write_end, record_descriptor);
    posix_spawn_file_actions_addchdir_np(&setup.actions, folder.c_str());
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&setup.attributes, &none);
    posix_spawnattr_setpgroup(&setup.attributes, 0);
    posix_spawnattr_setflags(&setup.attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);

    arguments.insert(arguments.begin(), program.string());
    std::vector<std::string> environment = scrubbed_environment(folder);
    const int error = posix_spawn(&process_, program.c_str(), &setup.actions, &setup.attributes,
                                  pointers(arguments).data(), pointers(environment).data());
    if (error == 0) return;
    throw InputError(program.string(), "cannot be started: " + message_of(error),
                     "install lepp-gmsh again, or name it in the environment variable LEPP_GMSH");
  }
  Helper(const Helper&) = delete;
  Helper& operator=(const Helper&) = delete;
  ~Helper() {
    if (process_ > 0) finish();
  }

  /// Kills what is left of the group and returns how the helper itself ended.
  int finish() {
    // It is not reaped yet, so its number cannot belong to anyone else.
    ::kill(-process_, SIGKILL);
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    return status;
  }

  /// Waits until the helper has ended by itself, but not beyond `deadline`.
  void wait_until(Clock::time_point deadline) const {
    siginfo_t info{};
    while (Clock::now() < deadline) {
      info.si_pid = 0;
      if (::waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOWAIT | WNOHANG) == 0 &&
          info.si_pid != 0)
        return;
      ::poll(nullptr, 0, 2);
    }
  }

 private:
  static std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> result;
    for (std::string& text : texts) result.push_back(text.data());
    result.push_back(nullptr);
    return result;
  }

  /// Nothing of the user's environment but the way to shared libraries.
  static std::vector<std::string> scrubbed_environment(const fs::path& folder) {
    std::vector<std::string> result = {"PATH=/usr/bin:/bin", "LC_ALL=C", "HOME=" + folder.string(),
                                       "TMPDIR=" + folder.string()};
    if (const char* libraries = std::getenv("LD_LIBRARY_PATH"); libraries != nullptr)
      result.push_back(std::string("LD_LIBRARY_PATH=") + libraries);
    return result;
  }

  pid_t process_ = -1;
};

/// All bytes up to the end of the pipe; nothing if the deadline came first.
std::optional<std::vector<std::byte>> read_until(int descriptor, Clock::time_point deadline,
                                                 std::size_t most, const GmshTask& task,
                                                 const GmshOptions& options) {
  std::vector<std::byte> bytes;
  std::array<std::byte, 65536> buffer;
  while (true) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
    if (left.count() <= 0) return std::nullopt;
    if (options.keep_going && !options.keep_going()) {
      throw RefusedError(task.display_name, "was cancelled while Gmsh read it", "run it again");
    }
    pollfd wait{descriptor, POLLIN, 0};
    const int ready =
        ::poll(&wait, 1, static_cast<int>(std::min<long long>(left.count() + 1, 1000)));
    if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
    const ssize_t n = ::read(descriptor, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return bytes;
    bytes.insert(bytes.end(), buffer.begin(), buffer.begin() + n);
    if (bytes.size() > most) return std::vector<std::byte>{};  // cannot be a record of this input
  }
}

[[noreturn]] void out_of_time(const GmshTask& task, const GmshOptions& options) {
  std::string seconds = std::to_string(options.seconds);
  seconds.erase(seconds.find_last_not_of('0') + 1);
  if (seconds.ends_with('.')) seconds.pop_back();
  throw RefusedError(task.display_name, "Gmsh did not finish reading it in " + seconds + " seconds",
                     "simplify its loops, sizes and fields (the limit is GmshOptions::seconds)");
}

[[noreturn]] void no_record(const GmshTask& task, const GmshOptions& options, int status) {
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL))
    out_of_time(task, options);
  const std::string how = WIFSIGNALED(status)
                              ? std::string("was stopped by signal ") + strsignal(WTERMSIG(status))
                              : "ended with status " + std::to_string(WEXITSTATUS(status));
  throw InputError(task.display_name, "Gmsh " + how + " while reading it, without a result",
                   "open the file in Gmsh to see what it objects to");
}

/// Folder of the running program.
fs::path program_folder() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : self.parent_path();
}

bool is_program(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error) && ::access(path.c_str(), X_OK) == 0;
}

}  // namespace

PrivateFolder::PrivateFolder() {
  std::error_code error;
  const fs::path parent = fs::temp_directory_path(error);
  std::string name = ((error ? fs::path("/tmp") : parent) / "lepp-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw OutputError(name, "cannot make a folder for temporary files: " + message_of(errno),
                      "name a folder that you may write to in TMPDIR");
  path_ = name;
}

PrivateFolder::~PrivateFolder() {
  std::error_code ignored;  // a folder of temporary files that cannot be removed harms nobody
  fs::remove_all(path_, ignored);
}

fs::path find_gmsh_helper(const GmshOptions& options) {
  std::vector<fs::path> places;
  if (options.helper) {
    places = {*options.helper};
  } else if (const char* named = std::getenv("LEPP_GMSH"); named != nullptr && *named != '\0') {
    places = {named};
  } else {
    const fs::path here = program_folder();
    places = {here / "lepp-gmsh", here.parent_path() / "libexec" / "lepp" / "lepp-gmsh"};
  }
  std::string tried;
  for (const fs::path& place : places) {
    if (is_program(place)) return fs::absolute(place);
    tried += (tried.empty() ? "" : " and ") + place.string();
  }
  throw InputError("lepp-gmsh",
                   "the program that reads Gmsh files is not there (tried " + tried + ")",
                   "install libgmsh-dev and build lepp with it, or name the program in the "
                   "environment variable LEPP_GMSH");
}

GmshRecord run_gmsh_helper(const PrivateFolder& folder, const GmshTask& task,
                           const GmshOptions& options) {
  const fs::path program = find_gmsh_helper(options);
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw RefusedError(task.display_name, "cannot make a pipe: " + message_of(errno),
                       "close other programs");
  Descriptor read_end(ends[0]), write_end(ends[1]);
  const double seconds = std::clamp(options.seconds, 0.01, 1e6);
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(seconds));
  Helper helper(program, folder.path(),
                {task.file, task.own_points ? "own-points" : "ends",
                 std::to_string(static_cast<long>(std::ceil(seconds)) + 1),
                 std::to_string(options.memory_bytes)},
                write_end.value());
  write_end.close();
  const auto bytes = read_until(read_end.value(), deadline, options.memory_bytes, task, options);
  if (!bytes) {
    helper.finish();
    out_of_time(task, options);
  }
  helper.wait_until(std::min(deadline, Clock::now() + std::chrono::seconds(1)));
  const int status = helper.finish();
  auto record = decode_gmsh_record(*bytes);
  if (!record) no_record(task, options, status);
  return std::move(*record);
}

}  // namespace lepp
