#include "lepp/geometry/text.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

using namespace lepp;

TEST_CASE("to_text writes the shortest digits that read back") {
  CHECK(to_text(0.1) == "0.1");
  CHECK(to_text(3.0) == "3");
  CHECK(to_text(-1e300) == "-1e+300");
  CHECK(to_text(1.0 / 3) == "0.3333333333333333");
}

TEST_CASE("to_text reads back as the same double") {
  for (double x : {std::nextafter(1.0, 2.0), 5e-324, std::numeric_limits<double>::max(), 500000.001,
                   -std::sqrt(2.0), -2.2250738585072014e-308}) {
    CAPTURE(x);
    CHECK(std::strtod(to_text(x).c_str(), nullptr) == x);
  }
}

TEST_CASE("a point reads (x, y)") { CHECK(to_text(Point{-0.5, 2}) == "(-0.5, 2)"); }

TEST_CASE("lower case is that of A to Z, and leaves all other bytes alone") {
  CHECK(lepp::lower_case("NCols_9.ASC") == "ncols_9.asc");
  CHECK(lepp::lower_case("@[`{\xC3\x84\xFF") == "@[`{\xC3\x84\xFF");
}
