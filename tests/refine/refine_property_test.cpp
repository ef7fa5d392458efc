#include <doctest/doctest.h>

#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/invariants.hpp"
#include "support/small_pslg.hpp"
#include "support/trial.hpp"

using namespace lepp;
using namespace lepp::test;

TEST_CASE("refine leaves a constrained Delaunay mesh, and a reason for each angle it missed") {
  CHECK(holds("refine", [](const SmallPslg& small) {
    const Pslg pslg = small.pslg_without_crossings();
    Trial trial = try_pslg(pslg, arrange(pslg), Crossings::refuse);
    RC_PRE(trial.result.has_value());
    Mesh& mesh = trial.result->mesh;
    const std::size_t before = mesh.vertex_count();
    const double angle = *rc::gen::element(10.0, 20.0, 30.0);
    const RefineReport report = refine(mesh, {.min_angle_deg = angle, .max_vertices = 400});
    if (const auto broken = broken_topology(mesh)) RC_FAIL(*broken);
    if (const auto broken = broken_delaunay(mesh)) RC_FAIL(*broken);
    RC_ASSERT(mesh.vertex_count() <= std::max<std::size_t>(400, before));
    RC_ASSERT(mesh.vertex_count() == before + report.steiner_points);
    const MeshClaims claims{.min_angle_deg = angle, .unfinished = report.unfinished};
    RC_ASSERT(validate(mesh, claims).summary() == "valid");
  }));
}
