// Random PSLGs, or predicate cases, until the count or the time is over.

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <unistd.h>

#include "stress/options.hpp"
#include "stress/save_case.hpp"
#include "stress/stress_case.hpp"
#include "support/oracle_cases.hpp"

namespace {

using namespace lepp;
using namespace lepp::test;
using Clock = std::chrono::steady_clock;

constexpr double longest_case_seconds = 60;

struct Totals {
  std::atomic<std::uint64_t> done{0}, meshes{0}, crossing{0}, refused_splits{0}, failures{0};
};

// What a thread works on, for the crash handler and the watchdog.
struct Current {
  const Pslg* pslg = nullptr;
  std::string path;
  std::atomic<Clock::rep> started{0};
};
thread_local Current* current = nullptr;

std::string case_path(const StressOptions& options, Family family, std::uint64_t seed) {
  const std::string name(family_names[static_cast<std::size_t>(family)]);
  return options.folder + "/stress_" + name + "_" + std::to_string(seed) + ".poly";
}

void say(const char* text) {
  std::size_t length = 0;
  while (text[length] != '\0') ++length;
  if (write(STDERR_FILENO, text, length) < 0) _exit(1);
}

void on_crash(int signal) {
  std::signal(signal, SIG_DFL);
  if (current != nullptr && current->pslg != nullptr) {
    save_case(*current->pslg, current->path.c_str());
    say("crash: ");
    say(current->path.c_str());
    say("\n");
  }
  std::raise(signal);
}

class Stress {
 public:
  explicit Stress(const StressOptions& options) : options_(options), start_(Clock::now()) {
    for (std::uint32_t i = 0; i < options.threads; ++i) {
      currents_.push_back(std::make_unique<Current>());
    }
  }

  int run() {
    std::vector<std::thread> threads;
    for (auto& mine : currents_) {
      threads.emplace_back([this, &mine] { work(*mine); });
    }
    std::thread watchdog([this] { watch(); });
    for (std::thread& t : threads) t.join();
    finished_ = true;
    watchdog.join();
    print_summary();
    return totals_.failures > 0 ? 1 : 0;
  }

 private:
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  void work(Current& mine) {
    current = &mine;
    constexpr std::uint64_t block = 64;
    while (options_.seconds <= 0 || elapsed() < options_.seconds) {
      const std::uint64_t first = next_.fetch_add(block);
      if (first >= options_.count) break;
      const std::uint64_t last = std::min(first + block, options_.count);
      for (std::uint64_t i = first; i < last; ++i) {
        mine.started = Clock::now().time_since_epoch().count();
        if (options_.predicates) ask_predicates(options_.seed + i);
        else triangulate(mine, options_.seed + i);
        ++totals_.done;
      }
    }
    mine.started = 0;
  }

  void ask_predicates(std::uint64_t seed) {
    const auto difference = predicate_difference(seed);
    if (difference) report_failure(*difference);
  }

  void triangulate(Current& mine, std::uint64_t seed) {
    const Family family = options_.family.value_or(static_cast<Family>(seed % family_names.size()));
    const Pslg pslg = generate_pslg(family, seed);
    mine.path = case_path(options_, family, seed);
    mine.pslg = &pslg;
    const CaseReport report =
        run_case(pslg, seed, options_.split ? Crossings::split : Crossings::refuse);
    totals_.meshes += report.made_mesh ? 1 : 0;
    totals_.crossing += report.crosses ? 1 : 0;
    totals_.refused_splits += report.refused_split ? 1 : 0;
    if (options_.save || report.failure) save_case(pslg, mine.path.c_str());
    if (report.failure) report_failure(mine.path + ": " + *report.failure);
    mine.pslg = nullptr;
  }

  void report_failure(const std::string& text) {
    const std::scoped_lock lock(printing_);
    if (++totals_.failures <= 20) std::fprintf(stderr, "%s\n", text.c_str());
  }

  // A case that does not end is a failure too.
  void watch() {
    while (!finished_) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      for (const auto& one : currents_) {
        const Clock::duration since(one->started.load());
        if (since.count() == 0) continue;
        const auto running = Clock::now().time_since_epoch() - since;
        if (std::chrono::duration<double>(running).count() < longest_case_seconds) continue;
        const Pslg* pslg = one->pslg;
        if (pslg != nullptr) save_case(*pslg, one->path.c_str());
        std::fprintf(stderr, "%s: did not end in %.0f s\n", one->path.c_str(),
                     longest_case_seconds);
        _exit(1);
      }
    }
  }

  void print_summary() const {
    const std::uint64_t done = totals_.done;
    if (options_.predicates) {
      std::printf("%llu predicate cases from seed %llu: %llu failures, %.1f s\n", number(done),
                  number(options_.seed), number(totals_.failures), elapsed());
      return;
    }
    std::printf(
        "%llu PSLGs from seed %llu: %llu failures; %llu meshes, %llu with crossings, of which "
        "%llu, "
        "once split, were refused for holes, seeds or no area; %.1f s\n",
        number(done), number(options_.seed), number(totals_.failures), number(totals_.meshes),
        number(totals_.crossing), number(totals_.refused_splits), elapsed());
  }

  static unsigned long long number(std::uint64_t n) { return n; }

  const StressOptions& options_;
  Clock::time_point start_;
  Totals totals_;
  std::vector<std::unique_ptr<Current>> currents_;
  std::atomic<std::uint64_t> next_{0};
  std::atomic<bool> finished_{false};
  std::mutex printing_;
};

}  // namespace

int main(int argc, char** argv) {
  const auto options = parse_stress_options(argc, argv);
  if (!options) return 2;
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS}) {
    std::signal(signal, on_crash);
  }
  return Stress(*options).run();
}
