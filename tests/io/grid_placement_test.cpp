#include <doctest/doctest.h>

#include <limits>

#include "io/grid_texts.hpp"
#include "lepp/geometry/text.hpp"

using namespace lepp;
using test::contains;
using test::error_of;
using test::read;
using test::refusal;

namespace {

// A grid of 3 x 2 whose first sample lies at `corner`.
std::string asc(double corner, double dx, double dy) {
  const std::string at = to_text(corner);
  return "ncols 3\nnrows 2\nxllcenter " + at + "\nyllcenter " + at + "\ndx " + to_text(dx) +
         "\ndy " + to_text(dy) + "\n1 2 3 4 5 6\n";
}

std::string fate(double corner, double dx, double dy) {
  return refusal("a.asc", asc(corner, dx, dy));
}

}  // namespace

TEST_CASE("coordinates too large for the distance of samples are refused") {
  CHECK(fate(5e6, 1e-3, 1e-3) == "");
  CHECK(fate(-1e17, 1e6, 1e6) == "");
  CHECK(contains(fate(1e17, 1, 1), "subtract"));
  CHECK(contains(fate(-1e17, 1, 1), "subtract"));
  CHECK(contains(fate(1e300, 1, 1), "larger than 1.6e60"));
  CHECK(contains(fate(1e62, 1e58, 1e58), "larger than 1.6e60"));
  CHECK(contains(fate(0, 1e-30, 1e-30), "smaller than 8.3e-25"));
}

TEST_CASE("cells a million times as long as wide are refused") {
  CHECK(fate(0, 1, 1e6) == "");
  CHECK(fate(0, 1e6, 1) == "");
  for (const auto& [dx, dy] :
       {std::pair(1.0, 1e-10), std::pair(1.0, 1e10), std::pair(1e-20, 1.0)}) {
    CAPTURE(dx);
    CAPTURE(dy);
    CHECK(contains(fate(0, dx, dy), "its cells are"));
  }
  const auto cell = [](double width, double height) {
    return error_of<InputError>([&] {
      read("a.asc", asc(0, 1, 1), {.cell = CellSize{width, height}});
    });
  };
  CHECK(cell(1, 1e6) == "");
  CHECK(contains(cell(1, 1e7), "its cells are 1 wide and 1e+07 high"));
  CHECK(contains(cell(1e300, 1e300), "its cells are"));
  CHECK(contains(cell(1e-300, 1e300), "its cells are"));
  CHECK(contains(cell(-1, 1), "not above 0"));
}

TEST_CASE("the window of a grid that is refused is refused too") {
  const test::ScratchFolder folder;
  const auto path = folder.put("a.asc", asc(1e17, 1, 1));
  CHECK(error_of<InputError>([&] { read_height_grid_header(path); }) != "");
  CHECK(error_of<InputError>([&] { read_height_window(path, {0, 0, 1, 1}); }) != "");
}
