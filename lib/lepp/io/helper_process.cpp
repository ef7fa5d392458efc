#include "lepp/io/helper_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

#include "lepp/geometry/error.hpp"

namespace lepp {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int record_descriptor = 3;  // where the helper writes, inherited

std::string message_of(int error) { return std::generic_category().message(error); }

class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { ::close(value_); }
  int value() const { return value_; }

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

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

/// Nothing of the user's environment but the way to shared libraries.
std::vector<std::string> scrubbed_environment(const fs::path& folder) {
  std::vector<std::string> result = {"PATH=/usr/bin:/bin", "LC_ALL=C", "HOME=" + folder.string(),
                                     "TMPDIR=" + folder.string()};
  if (const char* libraries = std::getenv("LD_LIBRARY_PATH"); libraries != nullptr)
    result.push_back(std::string("LD_LIBRARY_PATH=") + libraries);
  return result;
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

fs::path find_helper(const HelperProgram& helper, const std::optional<fs::path>& given) {
  std::vector<fs::path> places;
  if (given) {
    places = {*given};
  } else if (const char* named = std::getenv(helper.variable.c_str());
             named != nullptr && *named != '\0') {
    places = {named};
  } else {
    const fs::path here = program_folder();
    places = {here / helper.name, here.parent_path() / "libexec" / "lepp" / helper.name};
  }
  std::string tried;
  for (const fs::path& place : places) {
    if (is_program(place)) return fs::absolute(place);
    tried += (tried.empty() ? "" : " and ") + place.string();
  }
  throw InputError(
      helper.name,
      "the program that reads " + helper.library + " files is not there (tried " + tried + ")",
      "install " + helper.package +
          " and build lepp with it, or name the program in the "
          "environment variable " +
          helper.variable);
}

Helper::Helper(HelperTask task) : task_(std::move(task)) {
  task_.seconds = std::clamp(task_.seconds, 0.01, 1e6);
  deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                 std::chrono::duration<double>(task_.seconds));
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw RefusedError(task_.display_name, "cannot make a pipe: " + message_of(errno),
                       "close other programs");
  const Descriptor write_end(ends[1]);
  // A large buffer, where the system gives one, saves changes between the two programs.
  ::fcntl(ends[0], F_SETPIPE_SZ, 1 << 20);
  try {
    start(write_end.value());
  } catch (...) {
    ::close(ends[0]);
    throw;
  }
  read_end_ = ends[0];
}

Helper::~Helper() {
  if (process_ > 0) kill();
  ::close(read_end_);
}

void Helper::start(int write_end) {
  SpawnSetup setup;
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&setup.actions, stream, "/dev/null", O_RDWR, 0);
  posix_spawn_file_actions_adddup2(&setup.actions, write_end, record_descriptor);
  if (task_.runs_in == HelperTask::RunsIn::folder)
    posix_spawn_file_actions_addchdir_np(&setup.actions, task_.folder.c_str());
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&setup.attributes, &none);
  posix_spawnattr_setpgroup(&setup.attributes, 0);
  posix_spawnattr_setflags(&setup.attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);

  std::vector<std::string> arguments = task_.arguments;
  arguments.insert(arguments.begin(), task_.program.string());
  std::vector<std::string> environment = scrubbed_environment(task_.folder);
  const int error = posix_spawn(&process_, task_.program.c_str(), &setup.actions, &setup.attributes,
                                pointers(arguments).data(), pointers(environment).data());
  if (error == 0) return;
  process_ = -1;
  throw InputError(task_.program.string(), "cannot be started: " + message_of(error),
                   "install " + task_.helper.name +
                       " again, or name it in the environment variable " + task_.helper.variable);
}

int Helper::kill() {
  // It is not reaped yet, so its number cannot belong to anyone else.
  ::kill(-process_, SIGKILL);
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return status;
}

void Helper::wait_until(Clock::time_point deadline) const {
  siginfo_t info{};
  while (Clock::now() < deadline) {
    info.si_pid = 0;
    if (::waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOWAIT | WNOHANG) == 0 &&
        info.si_pid != 0)
      return;
    ::poll(nullptr, 0, 2);
  }
}

int Helper::finish() {
  wait_until(std::min(deadline_, Clock::now() + std::chrono::seconds(1)));
  return kill();
}

std::size_t Helper::read(std::span<std::byte> bytes) {
  while (true) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - Clock::now());
    if (left.count() <= 0) out_of_time();
    if (task_.keep_going && !task_.keep_going()) {
      throw RefusedError(task_.display_name,
                         "was cancelled while " + task_.helper.library + " read it",
                         "run it again");
    }
    pollfd wait{read_end_, POLLIN, 0};
    const int ready =
        ::poll(&wait, 1, static_cast<int>(std::min<long long>(left.count() + 1, 1000)));
    if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
    const ssize_t n = ::read(read_end_, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    return n <= 0 ? 0 : static_cast<std::size_t>(n);
  }
}

bool Helper::read_all(std::span<std::byte> bytes) {
  while (!bytes.empty()) {
    const std::size_t n = read(bytes);
    if (n == 0) return false;
    bytes = bytes.subspan(n);
  }
  return true;
}

void Helper::out_of_time() {
  if (process_ > 0) kill();
  std::string seconds = std::to_string(task_.seconds);
  seconds.erase(seconds.find_last_not_of('0') + 1);
  if (seconds.ends_with('.')) seconds.pop_back();
  throw RefusedError(task_.display_name,
                     task_.helper.library + " did not finish reading it in " + seconds + " seconds",
                     task_.time_remedy);
}

void Helper::fail_without_result() {
  const int status = finish();
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL))
    out_of_time();
  const std::string how = WIFSIGNALED(status)
                              ? std::string("was stopped by signal ") + strsignal(WTERMSIG(status))
                              : "ended with status " + std::to_string(WEXITSTATUS(status));
  throw InputError(task_.display_name,
                   task_.helper.library + " " + how + " while reading it, without a result",
                   "open the file in " + task_.helper.library + " to see what it objects to");
}

}  // namespace lepp
