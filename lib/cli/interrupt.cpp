#include "interrupt.hpp"

#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace lepp::cli {

namespace {

volatile std::sig_atomic_t stop_asked = 0;  // the one thing a signal handler may touch

// The first signal asks; a second one ends the process at once.
extern "C" void ask_to_stop(int signal) {
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
