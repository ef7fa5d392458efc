#include "lepp/terrain/validate_surface.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "terrain/surface_grids.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

struct Case {
  HeightGrid grid = wild(30, 24, 4);
  SimplifyReport report;
  Tin tin =
      simplify(grid, rectangle(grid), {.max_error = 8, .metric = TerrainMetric::surface}, report);
  SurfaceClaims claims{.bound = report.surface.bound, .violations = report.surface.violations};
  std::string first_rule() const {
    const auto found = validate_surface(grid, tin, claims).violations;
    return found.empty() ? "none" : found.front().rule;
  }
};

}  // namespace

TEST_CASE("validate_surface finds a violation that is not listed") {
  Case c;
  REQUIRE(c.claims.violations.size() > 5);
  CHECK(c.first_rule() == "none");
  c.claims.violations.erase(c.claims.violations.begin() + 3);
  CHECK(c.first_rule() == "S1");
}

TEST_CASE("validate_surface finds a list that is not true") {
  Case c;
  const auto good = c.claims.violations;
  c.claims.violations.push_back(good.front());  // twice
  CHECK(c.first_rule() == "S2");
  c.claims.violations = good;
  c.claims.violations.push_back({{TriangleId(c.tin.mesh.triangle_count()), 0}, KeptBy::shape});
  CHECK(c.first_rule() == "S2");
  for (std::size_t t = 0; t < c.tin.mesh.triangle_count(); ++t) {  // an edge that obeys
    c.claims.violations = good;
    const HalfEdge e{TriangleId(t), 0};
    const auto f = c.tin.mesh.twin(e);
    if (!f || f->triangle < e.triangle ||
        std::ranges::any_of(good, [&](const auto& v) { return v.edge == e; })) {
      continue;
    }
    c.claims.violations.push_back({e, KeptBy::shape});
    CHECK(c.first_rule() == "S2");
    break;
  }
}

TEST_CASE("validate_surface finds a rule that does not hold") {
  Case c;
  bool any = false;
  for (auto& v : c.claims.violations) {
    const KeptBy right = v.kept_by;
    if (right == KeptBy::constraint) continue;
    v.kept_by = KeptBy::constraint;
    CHECK(c.first_rule() == "S2");
    v.kept_by = right;
    if (right == KeptBy::plan_angle) {  // which is convex, and better in space
      for (const KeptBy wrong : {KeptBy::shape, KeptBy::angle}) {
        v.kept_by = wrong;
        CHECK(c.first_rule() == "S2");
      }
      v.kept_by = right;
      any = true;
      break;
    }
  }
  CHECK(any);
}

TEST_CASE("validate_surface checks the rule of the error against the samples") {
  const HeightGrid grid = hills(60, 45);
  SimplifyReport report;
  const Tin tin =
      simplify(grid, rectangle(grid), {.max_error = 6, .metric = TerrainMetric::surface}, report);
  SurfaceClaims claims{.bound = 6, .violations = report.surface.violations};
  REQUIRE(std::ranges::any_of(claims.violations,
                              [](const auto& v) { return v.kept_by == KeptBy::error; }));
  CHECK(validate_surface(grid, tin, claims).summary() == "valid");
  claims.bound = 60;  // then no flip was barred
  CHECK(validate_surface(grid, tin, claims).violations.front().rule == "S2");
}
