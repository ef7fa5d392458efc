#include "lepp/terrain/small_angles.hpp"

#include <doctest/doctest.h>

#include "lepp/triangulation/flip.hpp"
#include "support/hand_made.hpp"

using namespace lepp;

namespace {

// Two triangles with angles of 6 degrees, in a rectangle.
Mesh flat_rectangle() { return test::two_triangles({0, 0}, {10, 0}, {10, 1}, {0, 1}); }

}  // namespace

TEST_CASE("small_angles: the reason is the border's if it was met there, else the end's") {
  const Mesh mesh = flat_rectangle();
  AtKeptBorder at_border;
  at_border.add(mesh, TriangleId(1U));
  const auto reasons = [&](const LoopEnd& end) {
    std::vector<Reason> found;
    for (const Unfinished& u : small_angles(mesh, 30, end, at_border)) found.push_back(u.reason);
    return found;
  };
  using Reasons = std::vector<Reason>;
  CHECK(reasons({}) == Reasons{Reason::size_floor, Reason::kept_border});
  CHECK(reasons({.used_up = true}) == Reasons{Reason::budget, Reason::kept_border});
  CHECK(reasons({.cancelled = true, .used_up = true}) ==
        Reasons{Reason::cancelled, Reason::kept_border});
  CHECK(small_angles(mesh, 5, {}, at_border).empty());
}

TEST_CASE("AtKeptBorder: a triangle with other corners is another one") {
  Mesh mesh = test::two_triangles({0, 0}, {4, 0}, {4, 4}, {0, 4});
  AtKeptBorder at_border;
  at_border.add(mesh, TriangleId(0U));
  CHECK(at_border.contains(mesh, TriangleId(0U)));
  CHECK_FALSE(at_border.contains(mesh, TriangleId(1U)));
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (!mesh.is_constrained({TriangleId(0U), i})) {
      flip(mesh, {TriangleId(0U), i});
      break;
    }
  }
  CHECK_FALSE(at_border.contains(mesh, TriangleId(0U)));
  at_border.add(mesh, TriangleId(0U));
  at_border.clear();
  CHECK_FALSE(at_border.contains(mesh, TriangleId(0U)));
}

TEST_CASE("are_excused: by the input and by borders, by nothing else") {
  const TriangleId t(0U);
  CHECK(are_excused(std::vector<Unfinished>{}));
  CHECK(are_excused(std::vector<Unfinished>{
      {t, Reason::input_angle}, {t, Reason::input_feature}, {t, Reason::kept_border}}));
  for (const Reason reason : {Reason::size_floor, Reason::budget, Reason::cancelled}) {
    CHECK_FALSE(are_excused(std::vector<Unfinished>{{t, Reason::kept_border}, {t, reason}}));
  }
}
