#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <future>
#include <new>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

namespace lepp {

/// Runs both pieces of work, at the same time if `threads` is at least 2 and the system gives a
/// thread; else one after the other. They must not write what the other one reads.
/// \throw  what they throw, once both have ended; if both throw, the error of the first. One after
///         the other, the second is not started if the first throws.
template <class First, class Second>
void in_parallel(unsigned threads, First first, Second second) {
  std::optional<std::future<void>> other;
  if (threads >= 2) {
    try {
      other = std::async(std::launch::async, [&second] { second(); });
    } catch (const std::system_error&) {  // no thread to be had: one after the other
    }
  }
  first();  // if this throws, the future's destructor waits for the other one
  if (other) other->get();
  else second();
}

/// The same for many short pieces, one pair after the other: the thread is started for the first
/// pair that wants it, and looks out for the next one in between.
class SecondThread {
 public:
  SecondThread() = default;
  SecondThread(const SecondThread&) = delete;
  SecondThread& operator=(const SecondThread&) = delete;
  ~SecondThread() {
    if (!thread_.joinable()) return;
    work_ = nullptr;
    hand_over();
    thread_.join();
  }

  /// As in_parallel().
  template <class First, class Second>
  void run(unsigned threads, First first, Second second) {
    if (threads < 2 || !is_there()) {
      first();
      second();
      return;
    }
    work_ = [&second] { second(); };
    hand_over();
    try {
      first();
    } catch (...) {
      await(done_, turn_);
      error_ = nullptr;
      throw;
    }
    await(done_, turn_);
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
  }

 private:
  bool is_there() {
    if (thread_.joinable()) return true;
    try {
      thread_ = std::thread([this] { serve(); });
    } catch (const std::system_error&) {  // no thread to be had: one after the other
    } catch (const std::bad_alloc&) {     // likewise
    }
    return thread_.joinable();
  }

  void hand_over() {
    asked_.store(++turn_, std::memory_order_release);
    asked_.notify_one();
  }

  void serve() {
    for (std::uint32_t turn = 1;; ++turn) {
      await(asked_, turn);
      if (!work_) return;
      try {
        work_();
      } catch (...) {
        error_ = std::current_exception();
      }
      done_.store(turn, std::memory_order_release);
      done_.notify_one();
    }
  }

  // Tells the processor that this thread only waits.
  static void rest() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
  }

  // Most pieces take some tens of microseconds: sleeping at once would cost as much. A look with a
  // rest takes many times one without, and on a virtual machine may cost the processor
  // (docs/benchmarks.md).
  static void await(const std::atomic<std::uint32_t>& count, std::uint32_t turn) {
    constexpr int looks = 3000;
    for (int i = 0; i < looks; ++i) {
      if (count.load(std::memory_order_acquire) == turn) return;
      rest();
    }
    while (count.load(std::memory_order_acquire) != turn) count.wait(turn - 1);
  }

  std::thread thread_;
  std::function<void()> work_;  // nothing: the thread ends
  std::exception_ptr error_;
  std::uint32_t turn_ = 0;
  std::atomic<std::uint32_t> asked_ = 0, done_ = 0;
};

}  // namespace lepp
