#include "lepp/terrain/free_stars.hpp"

#include <doctest/doctest.h>

#include "lepp/triangulation/cavity.hpp"
#include "support/hand_made.hpp"

using namespace lepp;

TEST_CASE("FreeStars: what is frozen or of the input stays, others move 20 times") {
  Mesh mesh = test::two_triangles({0, 0}, {4, 0}, {4, 4}, {0, 4});
  FreeStars stars(mesh);
  Cavity cavity;
  REQUIRE(cavity.find(mesh, TriangleId(0U), {2, 1}));
  const VertexId v = cavity.fill(mesh, {2, 1}, {VertexOrigin::Kind::interior, 0});
  const TriangleId t = cavity.triangles()[0];  // v is its first corner
  Star star;
  CHECK(stars.frozen() == 4);
  CHECK_FALSE(is_free(mesh, VertexId(0U), 0));
  CHECK_FALSE(stars.find(t, 1, star));
  for (int move = 0; move < 20; ++move) {
    REQUIRE(stars.find(t, 0, star));
    stars.note_move(v);
  }
  CHECK(star.size() == 4);
  CHECK_FALSE(stars.find(t, 0, star));
  stars.forget_moves();
  CHECK(stars.find(t, 0, star));
  stars.freeze();
  CHECK_FALSE(stars.find(t, 0, star));
}
