#include "lepp/io/number_word.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "io/grid_texts.hpp"

using namespace lepp;

namespace {

const std::string zeros(400, '0');
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("a word is a number as from_chars has it, with a plus sign, NaN and infinities") {
  CHECK(number_of("1.5") == 1.5);
  CHECK(number_of("+1.5e2") == 150);
  CHECK(number_of("-7") == -7);
  CHECK(number_of("5e-324") == 5e-324);
  CHECK(number_of("inf") == infinity);
  CHECK(std::isnan(number_of("nan").value_or(0)));
  for (const char* word : {"", "+", "-", "x", "1,5", "1.5x", "+-1", "++1", "1e", "--1", "0x10"}) {
    CAPTURE(word);
    CHECK(number_of(word) == std::nullopt);
  }
}

TEST_CASE("numbers beyond doubles: too large is infinite, too small is 0, however it is written") {
  CHECK(number_of("1e999") == infinity);
  CHECK(number_of("-1e999") == -infinity);
  CHECK(number_of("1" + zeros) == infinity);
  CHECK(number_of("1" + zeros + "e1") == infinity);
  CHECK(number_of("0." + zeros + "1e900") == infinity);
  CHECK(number_of("1e-999") == 0);
  CHECK(number_of("0." + zeros + "1") == 0);
  CHECK(number_of("-." + zeros + "1E3") == 0);
  CHECK(number_of("1" + zeros + "e-800") == 0);
  CHECK(number_of("1e99999999999999999999") == infinity);
  CHECK(number_of("1e-99999999999999999999") == 0);
  CHECK(number_of("1" + zeros + "e-400") == 1);
}

TEST_CASE("a tiny height is 0 in a text grid, and a tiny value of no data in a header") {
  using test::asc_head;
  using test::read;
  using test::same;
  CHECK(same(read("a.asc", asc_head + "1 2 3 4 5 0." + zeros + "1").heights, {1, 2, 3, 4, 5, 0}));
  const std::string samples = test::bytes_of_values<float>({1, 2, 0, 4}, false);
  CHECK(same(read("a.f32", "F32 2 2 1e-999\n" + samples).heights, {1, 2, test::none, 4}));
  CHECK(same(read("a.f32", "F32 2 2 -1e999\n" + samples).heights, {1, 2, 0, 4}));
  CHECK(test::contains(test::refusal("a.f32", "F32 2 2 x\n" + samples), "header: \"x\""));
}
