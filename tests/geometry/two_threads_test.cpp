#include "lepp/geometry/two_threads.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

using namespace lepp;

namespace {

struct Outcome {
  std::string error;  // what was thrown
  bool first_ended = false, second_ended = false;
};

// Runs two pieces of work, which throw their names or end.
Outcome run(unsigned threads, bool first_throws, bool second_throws) {
  Outcome outcome;
  try {
    in_parallel(
        threads,
        [&] {
          if (first_throws) throw std::runtime_error("first");
          outcome.first_ended = true;
        },
        [&] {
          if (second_throws) throw std::runtime_error("second");
          outcome.second_ended = true;
        });
  } catch (const std::runtime_error& error) {
    outcome.error = error.what();
  }
  return outcome;
}

}  // namespace

TEST_CASE("both pieces of work are done before in_parallel ends") {
  for (const unsigned threads : {1U, 2U, 8U}) {
    const Outcome outcome = run(threads, false, false);
    CHECK(outcome.error.empty());
    CHECK(outcome.first_ended);
    CHECK(outcome.second_ended);
  }
}

TEST_CASE("one thread: one piece after the other, on the thread that asked") {
  std::string order;
  const auto asking = std::this_thread::get_id();
  in_parallel(
      1,
      [&] {
        order += "first";
        CHECK(std::this_thread::get_id() == asking);
      },
      [&] {
        order += ", second";
        CHECK(std::this_thread::get_id() == asking);
      });
  CHECK(order == "first, second");
}

TEST_CASE("an error of either arrives, and the other one has ended") {
  const Outcome first = run(2, true, false), second = run(2, false, true);
  CHECK(first.error == "first");
  CHECK(first.second_ended);
  CHECK(second.error == "second");
  CHECK(second.first_ended);
}

TEST_CASE("if both throw, the error of the first arrives") {
  CHECK(run(1, true, true).error == "first");
  for (int i = 0; i < 50; ++i) CHECK(run(2, true, true).error == "first");
}

TEST_CASE("one thread: if the first throws, the second is not started") {
  const Outcome outcome = run(1, true, false);
  CHECK(outcome.error == "first");
  CHECK_FALSE(outcome.second_ended);
  CHECK(run(1, false, true).error == "second");
}

TEST_CASE("a second thread does piece after piece, and has done each when run() ends") {
  for (const unsigned threads : {1U, 2U}) {
    CAPTURE(threads);
    SecondThread second;
    std::size_t by_first = 0, by_second = 0;
    for (std::size_t i = 1; i <= 1000; ++i) {
      second.run(
          threads, [&] { by_first += i; }, [&] { by_second += i; });
      REQUIRE(by_second == by_first);
    }
    CHECK(by_first == 500500);
  }
}

TEST_CASE("a second thread hands errors on, the first's if both throw, and works on") {
  const auto fail = [](const char* what) { return [what] { throw std::runtime_error(what); }; };
  SecondThread second;
  for (int i = 0; i < 20; ++i) {
    bool done = false;
    CHECK_THROWS_WITH(second.run(
                          2, [] {}, fail("second")),
                      "second");
    CHECK_THROWS_WITH(second.run(2, fail("first"), [&] { done = true; }), "first");
    CHECK(done);
    CHECK_THROWS_WITH(second.run(2, fail("first"), fail("second")), "first");
    done = false;
    second.run(
        2, [] {}, [&] { done = true; });
    CHECK(done);
  }
}

TEST_CASE("a second thread that sleeps wakes up") {
  SecondThread second;
  for (int i = 0; i < 3; ++i) {
    int done = 0;
    second.run(
        2, [] {}, [&] { ++done; });
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    CHECK(done == 1);
  }
}
