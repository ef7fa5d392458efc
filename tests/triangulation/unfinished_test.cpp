#include "lepp/triangulation/unfinished.hpp"

#include <doctest/doctest.h>

#include <utility>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/validate.hpp"

using namespace lepp;

namespace {

// One triangle, all of whose sides are segments.
Mesh triangle(Point a, Point b, Point c) {
  Pslg pslg;
  pslg.points = {a, b, c};
  for (const auto& [from, to] : {std::pair{0U, 1U}, {1U, 2U}, {2U, 0U}}) {
    pslg.segments.push_back({VertexId(from), VertexId(to), {}, 0, 1});
  }
  return constrained_delaunay(pslg).mesh;
}

bool is_excused(const Mesh& mesh, Reason reason) {
  const Unfinished claimed{TriangleId(0U), reason};
  return validate(mesh, {.max_angle_deg = 90, .unfinished = {claimed}}).valid();
}

}  // namespace

TEST_CASE("sides that differ by an ulp enclose a wedge of 1e-9 with an obtuse angle by rounding") {
  const Mesh thin = triangle({0, 0}, {1, 0}, {1 + 0x1p-52, 1e-9});
  CHECK(is_obtuse_by_rounding(thin, TriangleId(0U)));
  CHECK(is_excused(thin, Reason::input_angle));
}

TEST_CASE("an obtuse angle that coordinates can better is no matter of rounding") {
  const Mesh longer = triangle({0, 0}, {1, 0}, {1 + 1e-10, 1e-9});  // one side much longer
  const Mesh wide = triangle({0, 0}, {1, 0}, {1 + 0x1p-52, 1e-3});  // room for an acute one
  const Mesh acute = triangle({0, 0}, {1, 0}, {1 - 1e-19, 1e-9});
  for (const Mesh* mesh : {&longer, &wide}) {
    CHECK_FALSE(is_obtuse_by_rounding(*mesh, TriangleId(0U)));
    CHECK_FALSE(is_excused(*mesh, Reason::input_angle));
  }
  CHECK_FALSE(is_obtuse_by_rounding(acute, TriangleId(0U)));
}

TEST_CASE("an input segment below twice the size floor is a feature of the input") {
  const Mesh fine = triangle({0, 0}, {1, 0}, {1, 1e-13}),
             coarse = triangle({0, 0}, {1, 0}, {1, 1e-3});
  CHECK(InputReasons(fine).by_feature(TriangleId(0U)));
  CHECK_FALSE(InputReasons(coarse).by_feature(TriangleId(0U)));
}
