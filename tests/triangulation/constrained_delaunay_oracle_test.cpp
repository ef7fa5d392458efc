#include <doctest/doctest.h>

#include <algorithm>

#include "support/gen_pslg.hpp"
#include "support/invariants.hpp"
#include "support/oracle_cdt.hpp"
#include "support/sanitized.hpp"
#include "support/trial.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

// The families that make PSLGs of a dozen points; the others need more.
constexpr std::array small_families{Family::random,     Family::grid,     Family::rotated_grid,
                                    Family::ulp_jitter, Family::offset,   Family::scale,
                                    Family::overlap,    Family::crossings};

std::vector<OracleCdt::Corners> triangles_of(const Mesh& mesh, const Arrangement& arrangement) {
  std::vector<OracleCdt::Corners> triangles;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    OracleCdt::Corners corners{};
    for (std::uint32_t i = 0; i < 3; ++i) {
      corners[i] = arrangement.point_of[mesh.origin_of(mesh.vertex(TriangleId(t), i)).index];
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.push_back(corners);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

}  // namespace

TEST_CASE("the brute-force oracle knows a square, a kite and a wall") {
  Pslg pslg;
  pslg.points = {{0, 0}, {2, -1}, {4, 0}, {2, 1}};
  const OracleCdt kite = brute_force_cdt(arrange(pslg), {});
  CHECK(kite.unique);
  CHECK(kite.triangles == std::vector<OracleCdt::Corners>{{0, 1, 3}, {1, 2, 3}});
  pslg.segments.push_back({VertexId(0U), VertexId(2U), {}, 0, 1});  // against Delaunay
  const OracleCdt wall = brute_force_cdt(arrange(pslg), {});
  CHECK(wall.triangles == std::vector<OracleCdt::Corners>{{0, 1, 2}, {0, 2, 3}});
  pslg.segments.clear();
  pslg.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const OracleCdt square = brute_force_cdt(arrange(pslg), {});
  CHECK_FALSE(square.unique);
  CHECK(square.triangles.size() == 4);
}

TEST_CASE("the CDT equals the brute-force oracle on 200,000 small PSLGs") {
  std::size_t compared = 0, unique = 0;
  for (std::uint64_t seed = 0; compared < cases(200'000); ++seed) {
    const Family family = small_families[seed % small_families.size()];
    const int points = 4 + static_cast<int>(seed / small_families.size() % 5);
    const Pslg pslg = generate_pslg(family, seed, points);
    if (pslg.points.size() > 12) continue;
    CAPTURE(seed);
    const Arrangement arrangement = arrange(pslg);
    const Trial trial = try_pslg(pslg, arrangement, Crossings::refuse);
    REQUIRE_MESSAGE(!trial.failure, *trial.failure);
    if (!trial.result) continue;
    ++compared;
    const OracleCdt oracle = brute_force_cdt(arrangement, pslg.holes);
    const auto triangles = triangles_of(trial.result->mesh, arrangement);
    if (oracle.unique) {
      ++unique;
      REQUIRE(triangles == oracle.domain);
    } else {
      REQUIRE(std::includes(oracle.triangles.begin(), oracle.triangles.end(), triangles.begin(),
                            triangles.end()));
    }
  }
  CHECK(unique > compared / 4);
}

TEST_CASE("the CDT equals that of the plain kernel on PSLGs of up to 600 points") {
  std::size_t meshes = 0;
  for (std::uint64_t seed = 0; seed < cases(3'000); ++seed) {
    const Family family = static_cast<Family>(seed % family_names.size());
    const int points = 40 + static_cast<int>(seed * 7 % 560);
    const Pslg pslg = generate_pslg(family, seed, points);
    CAPTURE(seed);
    CAPTURE(points);
    CAPTURE(family_names[seed % family_names.size()]);
    const Trial trial = try_pslg(pslg, arrange(pslg), Crossings::refuse);
    REQUIRE_MESSAGE(!trial.failure, *trial.failure);
    if (!trial.result) continue;
    ++meshes;
    const auto difference = difference_from_plain(*trial.result, pslg);
    REQUIRE_MESSAGE(!difference, *difference);
  }
  CHECK(meshes > cases(3'000) / 2);
}
