#include "lepp/terrain/heights.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "terrain/hills.hpp"
#include "terrain/plain_error.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

bool is_same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

// The same heights as doubles, though all of them may be floats.
HeightGrid widened(HeightGrid grid) {
  const double first = grid.heights[0];
  grid.heights.set(0, 0.1);
  grid.heights.set(0, first);
  REQUIRE(!grid.heights.are_floats());
  return grid;
}

}  // namespace

TEST_CASE("is_float: what a float holds and nothing else, at both ends of the range") {
  const double denormal = std::numeric_limits<float>::denorm_min();
  const double largest = std::numeric_limits<float>::max();
  for (const double yes :
       {0.0, -0.0, 0.5, 16777216.0, denormal, largest, double(0.1F), double(NAN)})
    CHECK(is_float(yes));
  for (const double no : {0.1, 16777217.0, denormal / 2, largest * (1 + 0x1p-30), 1e300, 5e-324,
                          std::numeric_limits<double>::infinity()})
    CHECK(!is_float(no));
}

TEST_CASE("heights come back as they went in, whichever way, and are floats while they can be") {
  constexpr std::uint64_t seed = 3;
  CAPTURE(seed);
  Random random(seed);
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    Heights heights;
    std::vector<double> wanted;
    bool all_floats = true;
    for (int k = random.between(1, 12); k > 0; --k) {
      const std::vector<double> pool = {1, 2.5, NAN, 0.1, 1e300, -3, 7, 8};
      const std::size_t kinds = random.one_in(2) ? 3 : 8;  // of them the first three are floats
      std::vector<double> some;
      for (std::uint32_t n = random.below(4); n > 0; --n)
        some.push_back(pool[random.below(static_cast<std::uint32_t>(kinds))]);
      for (const double h : some) all_floats &= is_float(h);
      const bool replaces = random.one_in(3) && some.size() <= wanted.size();
      if (replaces) {
        std::ranges::copy(some, wanted.begin());
        heights.assign(0, some);
      } else if (random.one_in(2)) {
        wanted.insert(wanted.end(), some.begin(), some.end());
        heights.append(some);
      } else {
        for (const double h : some) {
          wanted.push_back(h);
          heights.push_back(h);
        }
      }
    }
    CHECK(heights.are_floats() == all_floats);
    REQUIRE(heights.size() == wanted.size());
    for (std::size_t k = 0; k < wanted.size(); ++k) CHECK(is_same(heights[k], wanted[k]));
    CHECK(heights.bytes() >= wanted.size() * (all_floats ? 4 : 8));
  }
}

TEST_CASE("new heights are without data; what is reserved stays so when they become doubles") {
  Heights heights;
  heights.reserve(100);
  heights.append(std::vector<float>{1, 2});
  heights.resize(4);
  CHECK(heights.bytes() == 400);
  heights.set(1, 0.1);
  CHECK(heights.bytes() == 800);
  CHECK(heights[0] == 1);
  CHECK(heights[1] == 0.1);
  CHECK(std::isnan(heights[3]));
}

TEST_CASE("heights kept as doubles make as good a TIN as the same ones kept as floats") {
  HeightGrid floats = rough(40, 30, 5);
  for (std::uint32_t k = 0; k < 25; ++k) floats.heights.set(12 * 40 + k, NAN);
  const HeightGrid doubles = widened(floats);
  REQUIRE(floats.heights.are_floats());
  const TerrainDomain domain = terrain_domain(floats), same = terrain_domain(doubles);
  CHECK(domain.pslg.points == same.pslg.points);
  for (const double error : {0.0, 6.0}) {
    SimplifyReport of_floats, of_doubles;
    const SimplifyOptions options{.max_error = error, .by = SimplifyBy::greedy};
    const Tin a = simplify(floats, domain, options, of_floats);
    const Tin b = simplify(doubles, domain, options, of_doubles);
    CHECK(double(b.mesh.vertex_count()) <= 1.02 * double(a.mesh.vertex_count()));
    CHECK(measure_error(floats, b).max == measure_error(doubles, b).max);
    CHECK(measure_error(floats, a).rms == measure_error(doubles, a).rms);
  }
}

TEST_CASE("the error is kept where floats would lose all of the relief") {
  struct Case {
    const char* name;
    double unit;
    HeightGrid grid;
  };
  Random random(8);
  const auto micro = [&](double x, double y) {
    return 1e6 + 1e-6 * std::round(hill(x, y) / 10 + double(random.below(3)));
  };
  const auto whole = [](double x, double y) { return 2e9 + std::round(hill(x, y)); };
  const auto huge = [](double x, double y) { return 1e50 * hill(x, y); };
  const auto tiny = [](double x, double y) { return 1e-310 * hill(x, y); };
  for (const Case& c : {Case{"1e6 + k 1e-6", 1e-6, exact_grid_of(21, 18, micro)},
                        Case{"beyond 2^24", 1, exact_grid_of(21, 18, whole)},
                        Case{"beyond floats", 1e50, exact_grid_of(21, 18, huge)},
                        Case{"below floats", 1e-310, exact_grid_of(21, 18, tiny)}}) {
    CAPTURE(std::string(c.name));
    for (const SimplifyBy by : {SimplifyBy::lepp, SimplifyBy::greedy}) {
      for (const double error : {0.0, 1.0, 3.0}) {
        CAPTURE(error);
        SimplifyReport report;
        const Tin tin =
            simplify(c.grid, rectangle(c.grid), {.max_error = error * c.unit, .by = by}, report);
        CHECK(report.goal_reached);
        CHECK(report.error.lost == 0);
        const double slack = kept_error(0, interpolation_rounding(c.grid));
        CHECK(report.error.max <= error * c.unit * (1 + 1e-9) + slack);
        CHECK(std::abs(report.error.max - plain_error(c.grid, tin).max) <= slack);
      }
    }
  }
}

TEST_CASE("heights: the range of floats and of doubles, NaN left out, none of none") {
  Heights heights;
  CHECK(heights.range().count == 0);
  CHECK(heights.range().low > heights.range().high);
  heights.push_back(NAN);
  CHECK(heights.range().count == 0);
  heights.push_back(-2);
  heights.push_back(5);
  for (const double more : {0.5, 0.1}) {  // 0.1 is no float
    heights.push_back(more);
    CHECK(heights.range().low == -2);
    CHECK(heights.range().high == 5);
  }
  CHECK(heights.range().count == 4);
}
