#include <doctest/doctest.h>

#include <cmath>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "terrain/hills.hpp"
#include "terrain/plain_error.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

Tin tin_of(const HeightGrid& grid, const TerrainDomain& domain) {
  Tin tin{constrained_delaunay(domain.pslg).mesh, {}};
  for (const Point p : tin.mesh.points()) {
    tin.heights.push_back(grid.height(static_cast<std::uint32_t>(p.x),
                                      grid.row_of_line(static_cast<std::uint32_t>(p.y))));
  }
  return tin;
}

}  // namespace

TEST_CASE("measure_error: a plane has none; a spike is found where it is, with its sign") {
  for (const double step : {-1.0, 1.0}) {
    HeightGrid grid = grid_of(9, 7, [](double x, double y) { return 4 * x + y; });
    grid.step_y = step;
    Tin tin = tin_of(grid, rectangle(grid));
    CHECK(measure_error(grid, tin).max < 1e-12);
    CHECK(measure_error(grid, tin).samples == 63);
    raise(grid, 5, 2, 3);
    raise(grid, 4, 6, -8);  // on the rim
    const TerrainError error = measure_error(grid, tin);
    CHECK(error.max == doctest::Approx(8));
    CHECK(error.column == 4);
    CHECK(error.row == 6);
    CHECK(error.highest == doctest::Approx(3));
    CHECK(error.lowest == doctest::Approx(-8));
    CHECK(error.rms == doctest::Approx(std::sqrt((9.0 + 64.0) / 63)));
    CHECK(error.lost == 0);
  }
}

TEST_CASE("measure_error: samples outside the mesh are lost, those without data are covered") {
  HeightGrid grid = hills(12, 9);
  TerrainDomain part;
  part.pslg = polygon({0, 0, 11, 0, 11, 8});  // half of it: lines above the diagonal are outside
  const Tin half = tin_of(grid, part);
  const PlainError plain = plain_error(grid, half);
  CHECK(measure_error(grid, half).lost == plain.lost);
  CHECK(measure_error(grid, half).samples == plain.samples);
  const Tin all = tin_of(grid, rectangle(grid));
  grid.heights.set(30, NAN);
  grid.heights.set(31, NAN);
  CHECK(measure_error(grid, all).covered == 2);
  CHECK(measure_error(grid, all).samples == 12 * 9 - 2);
}

TEST_CASE("measure_error: as by brute force, samples on sides counted once") {
  const HeightGrid grid = rough(31, 24, 3);
  SimplifyReport report;
  const Tin tin =
      simplify(grid, rectangle(grid), {.max_error = 20, .by = SimplifyBy::greedy}, report);
  const PlainError plain = plain_error(grid, tin);
  const TerrainError error = measure_error(grid, tin);
  CHECK(error.max == doctest::Approx(plain.max));
  CHECK(error.samples == plain.samples);
  CHECK(error.rms == doctest::Approx(std::sqrt(plain.sum_of_squares / double(plain.samples))));
}

TEST_CASE("measure_error: the same by one thread and by two") {
  const HeightGrid grid = rough(400, 350, 11);  // enough samples for a second thread
  SimplifyReport report;
  const Tin tin = simplify(grid, terrain_domain(grid), {.max_error = 6}, report);
  const TerrainError one = measure_error(grid, tin, nullptr, 1),
                     two = measure_error(grid, tin, nullptr, 2);
  CHECK(one.max == two.max);
  CHECK(one.column == two.column);
  CHECK(one.row == two.row);
  CHECK(one.rms == two.rms);
  CHECK(one.highest == two.highest);
  CHECK(one.lowest == two.lowest);
  CHECK(one.samples == grid.size());
  CHECK(two.samples == grid.size());
}
