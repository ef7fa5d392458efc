#pragma once

#include <chrono>
#include <cstddef>

namespace lepp::cli {

/// From now on the first Ctrl-C or SIGTERM only sets a flag, and writing past a file-size limit or
/// into a closed pipe is an error that a writer sees, not the end of the process.
void catch_signals();

/// True once the user asked to stop.
bool interrupted();

/// While one of these lives, Ctrl-C or SIGTERM ends the process at once, with status 4: for work
/// that cannot be told to stop, with no file open and no child running.
class EndsAtOnce {
 public:
  EndsAtOnce();
  ~EndsAtOnce();
  EndsAtOnce(const EndsAtOnce&) = delete;
  EndsAtOnce& operator=(const EndsAtOnce&) = delete;
};

/// Shows the number of vertices on a terminal, for work that takes longer than a second, and
/// wipes it when done.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Called now and then; returns false once the user asked to stop.
  bool operator()(std::size_t vertices);

 private:
  std::chrono::steady_clock::time_point start_, shown_;
  bool terminal_;
  bool drawn_ = false;
};

}  // namespace lepp::cli
