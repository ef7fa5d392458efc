#include "lepp/io/line_reader.hpp"

#include <doctest/doctest.h>

#include "io/scratch_folder.hpp"
#include "lepp/geometry/error.hpp"

using namespace lepp;
using test::contains;
using test::error_of;

namespace {

// The error of reading the first field of `text` by `read`.
std::string error_in(const std::string& text, auto read) {
  const TextFile file{"a.poly", text};
  LineReader line(file);
  line.need("a line");
  return error_of<InputError>([&] { read(line); });
}

}  // namespace

TEST_CASE("fields are found behind every kind of line end, blank and comment") {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    CAPTURE(end);
    const TextFile file{"a", "# head" + end + "1\t2.5  3" + end + end + " 4 # tail" + end + "5"};
    LineReader line(file);
    REQUIRE(line.next());
    CHECK(line.fields() == 3);
    CHECK(line.integer(0, "n") == 1);
    CHECK(line.number(1, "x") == 2.5);
    CHECK(line.where() == "a, line 2");
    REQUIRE(line.next());
    CHECK(line.fields() == 1);
    CHECK(line.where() == "a, line 4");
    REQUIRE(line.next());
    CHECK(line.integer(0, "n") == 5);
    CHECK_FALSE(line.next());
  }
}

TEST_CASE("numbers read as C++ reads them, with or without plus sign") {
  const TextFile file{"a", "+3 -3 +1.5e3 .5 1e-3"};
  LineReader line(file);
  line.need("a line");
  CHECK(line.integer(0, "n") == 3);
  CHECK(line.integer(1, "n") == -3);
  CHECK(line.number(2, "x") == 1500);
  CHECK(line.number(3, "x") == 0.5);
  CHECK(line.number(4, "x") == 1e-3);
}

TEST_CASE("a decimal comma and an exponent with D are refused with a word on how to write them") {
  const auto number = [](const LineReader& line) { line.number(0, "x of vertex 3"); };
  for (const std::string text : {"1,0", "-1,5e3", ",5"}) {
    CHECK(contains(error_in(text, number), "use a decimal point"));
  }
  for (const std::string text : {"1.0D0", "-3d-2"}) {
    CHECK(contains(error_in(text, number), "write exponents with e"));
  }
  for (const std::string text : {"nan", "north,east", "D", "1.0.0"}) {
    CHECK(contains(error_in(text, number), "correct the line"));
  }
}

TEST_CASE("what is no number is quoted with its line") {
  const auto number = [](const LineReader& line) { line.number(0, "x of vertex 3"); };
  const auto integer = [](const LineReader& line) { line.integer(0, "the marker"); };
  for (const std::string text : {"nan", "inf", "-inf", "1.5x", "1,5", "0x10", "--1", "+-1", "+"}) {
    CAPTURE(text);
    CHECK(contains(error_in("\n" + text, number), "a.poly, line 2: x of vertex 3 is \"" + text));
  }
  for (const std::string text : {"1.0", "9999999999999999999", "one"}) {
    CHECK(contains(error_in(text, integer), "not a whole number"));
  }
  CHECK(contains(error_in("1e999", number), "too large or too small for a double"));
  CHECK(
      contains(error_in("1", [](const LineReader& line) { line.number(1, "y"); }), "y is missing"));
}

TEST_CASE("coordinates outside the supported range are refused") {
  const auto coordinate = [](const LineReader& line) { line.coordinate(0, "y of vertex 7"); };
  CHECK(error_in("0", coordinate).empty());
  CHECK(error_in("-1e50", coordinate).empty());
  CHECK(contains(error_in("1e300", coordinate), "y of vertex 7 is \"1e300\", outside"));
  CHECK(contains(error_in("-4.9e-324", coordinate), "y of vertex 7 is \"-4.9e-324\", outside"));
}

TEST_CASE("a count that the rest of the file cannot hold is refused") {
  const auto count = [](const LineReader& line) { line.count(0, "vertices", 6); };
  CHECK(error_in("2\n0 0 0\n1 1 1\n", count).empty());
  CHECK(error_in("2\n0 0 0\n1 1 1", count).empty());  // no final line end
  CHECK(contains(error_in("3\n0 0 0\n1 1 1\n", count), "announces 3 vertices"));
  CHECK(contains(error_in("4294967299\n0 0 0\n", count), "announces 4294967299 vertices"));
  CHECK(contains(error_in("-1\n", count), "the number of vertices is -1"));
}

TEST_CASE("a file that ends early names what is missing") {
  const TextFile file{"a", "1\n\n"};
  LineReader line(file);
  line.need("a vertex");
  CHECK(contains(error_of<InputError>([&] { line.need("a hole"); }),
                 "a, line 2: the file ends where a hole should be"));
}
