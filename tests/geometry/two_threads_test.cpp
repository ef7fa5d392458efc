#include "lepp/geometry/two_threads.hpp"

#include <doctest/doctest.h>

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
