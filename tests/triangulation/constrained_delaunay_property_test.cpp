#include <doctest/doctest.h>

#include "support/small_pslg.hpp"
#include "support/trial.hpp"

using namespace lepp;
using namespace lepp::test;

TEST_CASE("every PSLG gives a mesh with all invariants, or an error that has a reason") {
  CHECK(holds("constrained_delaunay, crossings refused", [](const SmallPslg& small) {
    const Pslg pslg = small.pslg();
    const Trial trial = try_pslg(pslg, arrange(pslg), Crossings::refuse);
    RC_CLASSIFY(trial.result.has_value(), "mesh");
    if (trial.failure) RC_FAIL(*trial.failure);
  }));
}

TEST_CASE("crossings are split within a few ulp of both segments") {
  CHECK(holds("constrained_delaunay, crossings split", [](const SmallPslg& small) {
    const Pslg pslg = small.pslg();
    const Arrangement arrangement = arrange(pslg);
    RC_CLASSIFY(!arrangement.crossings.empty(), "crosses");
    const Trial trial = try_pslg(pslg, arrangement, Crossings::split);
    if (trial.failure) RC_FAIL(*trial.failure);
  }));
}

TEST_CASE("the kernel and the plain one agree") {
  CHECK(holds("constrained_delaunay equals plain", [](const SmallPslg& small) {
    const Pslg pslg = small.pslg_without_crossings();
    const Trial trial = try_pslg(pslg, arrange(pslg), Crossings::refuse);
    RC_PRE(trial.result.has_value());
    const auto difference = difference_from_plain(*trial.result, pslg);
    if (difference) RC_FAIL(*difference);
  }));
}

TEST_CASE("scaling by a power of two changes no triangle") {
  CHECK(holds("scaling", [](const SmallPslg& small) {
    Pslg pslg = small.pslg_without_crossings();
    const Trial before = try_pslg(pslg, arrange(pslg), Crossings::refuse);
    for (Point& p : pslg.points) p = 0x1p+100 * p;
    const Trial after = try_pslg(pslg, arrange(pslg), Crossings::refuse);
    RC_ASSERT(before.result.has_value() == after.result.has_value());
    RC_PRE(before.result.has_value());
    const Mesh &a = before.result->mesh, &b = after.result->mesh;
    RC_ASSERT(a.triangle_count() == b.triangle_count());
    for (std::size_t t = 0; t < a.triangle_count(); ++t) {
      RC_ASSERT(a.vertices(TriangleId(t)) == b.vertices(TriangleId(t)));
    }
  }));
}
