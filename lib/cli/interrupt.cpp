#include "interrupt.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>

#include "commands.hpp"

namespace lepp::cli {

namespace {

// What a signal handler may touch, and threads may read.
std::atomic<int> stop_asked = 0;
std::atomic<int> nothing_to_lose = 0;
static_assert(std::atomic<int>::is_always_lock_free);

// The first signal asks, unless nobody would hear it; a second one ends the process at once.
extern "C" void ask_to_stop(int signal) {
  if (nothing_to_lose != 0) {
    constexpr char message[] = "lepp: cancelled; nothing was written\n";
    [[maybe_unused]] const auto written = ::write(2, message, sizeof message - 1);
    ::_exit(refused);
  }
  stop_asked = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_signals() {
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  std::signal(SIGHUP, ask_to_stop);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted() { return stop_asked != 0; }

EndsAtOnce::EndsAtOnce() {
  nothing_to_lose = 1;
  if (interrupted()) ask_to_stop(SIGINT);  // it came before, and was not heard yet
}

EndsAtOnce::~EndsAtOnce() { nothing_to_lose = 0; }

Progress::Progress()
    : start_(std::chrono::steady_clock::now()), shown_(start_), terminal_(isatty(2) != 0) {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

bool Progress::operator()(std::size_t vertices) {
  if (terminal_) {
    using namespace std::chrono_literals;
    const auto now = std::chrono::steady_clock::now();
    if (now - start_ > 1s && now - shown_ > 100ms) {
      std::fprintf(stderr, "\r%zu vertices\033[K", vertices);
      shown_ = now;
      drawn_ = true;
    }
  }
  return !interrupted();
}

}  // namespace lepp::cli
