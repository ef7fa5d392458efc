#include "lepp/voronoi/admissible.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "support/hand_made.hpp"

using namespace lepp;
using namespace lepp::test;

namespace {

std::set<std::string> broken_rules(const Certificate& certificate) {
  std::set<std::string> rules;
  for (const BoxViolation& violation : certificate.violations) rules.insert(violation.rule);
  return rules;
}

std::set<std::string> broken_rules(const Mesh& mesh) {
  return broken_rules(certify(mesh, voronoi_boxes(mesh)));
}

using Rules = std::set<std::string>;

// A mesh with an interface, and its boxes, to be damaged.
struct Sound {
  Mesh mesh = grid({.columns = 4, .rows = 4, .jitter = 0.15, .regions = 2});
  VoronoiBoxes boxes = voronoi_boxes(mesh);
};

}  // namespace

TEST_CASE("Delaunay meshes without obtuse angles at the boundary are admissible") {
  CHECK(certify(square(), voronoi_boxes(square())).summary() == "admissible");
  CHECK(certify(hexagon(), voronoi_boxes(hexagon())).admissible);
  const Sound sound;
  const Certificate certificate = certify(sound.mesh, sound.boxes);
  CHECK(certificate.summary() == "admissible");
  CHECK(certificate.offending.empty());
  CHECK(certificate.largest_area_defect < 1e-14);
}

TEST_CASE("V1 alone fails for an obtuse angle opposite the boundary") {
  const Mesh mesh = from_triangles({{0, 0}, {4, 0}, {2, 1}}, {{0, 1, 2}});
  const Certificate certificate = certify(mesh, voronoi_boxes(mesh));
  CHECK_FALSE(certificate.admissible);
  CHECK(broken_rules(certificate) == Rules{"V1"});
  REQUIRE(certificate.offending.size() == 1);
  CHECK(certificate.offending[0].k == VertexId(0U));
  CHECK(certificate.offending[0].l == VertexId(1U));
  CHECK(certificate.summary().starts_with(
      "not admissible: V1 edge (0, 0) - (4, 0) in surface 1: factor -0.375, opposite angles 126."));
}

TEST_CASE("V1 alone fails for an obtuse angle opposite an interface, and only because of it") {
  CHECK(broken_rules(two_triangles({-2, 0}, {0, -1}, {2, 0}, {0, 5}, 0)).empty());
  CHECK(broken_rules(two_triangles({-2, 0}, {0, -1}, {2, 0}, {0, 5}, 1)) == Rules{"V1"});
}

TEST_CASE("V1 sees an edge that misses Delaunay by one ulp") {
  const double nearer = std::nextafter(1, 0);
  CHECK(broken_rules(two_triangles({0, 0}, {nearer, 0}, {1, 1}, {0, 1})) == Rules{"V1"});
}

TEST_CASE("V1 and V2 fail where an edge is not Delaunay: boxes overlap") {
  const Mesh mesh = two_triangles({-2, 0}, {0, -1}, {2, 0}, {0, 0.5});
  const Certificate certificate = certify(mesh, voronoi_boxes(mesh));
  CHECK(broken_rules(certificate) == Rules{"V1", "V2"});
  CHECK(certificate.largest_area_defect > 0.01);
}

TEST_CASE("V2 alone fails for a box whose area is wrong") {
  for (const double factor : {1 + 1e-9, 0.5, -1.0, std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity()}) {
    CAPTURE(factor);
    Sound damaged;
    damaged.boxes.boxes[7].area *= factor;
    const Certificate certificate = certify(damaged.mesh, damaged.boxes);
    CHECK(broken_rules(certificate) == Rules{"V2"});
    CHECK(certificate.largest_area_defect > 1e-12);
  }
}

TEST_CASE("V2 alone fails for two wrong boxes whose errors cancel") {
  Sound damaged;
  const double tenth = 0.1 * damaged.boxes.boxes[0].area;
  damaged.boxes.boxes[0].area += tenth;
  damaged.boxes.boxes[1].area -= tenth;
  CHECK(broken_rules(certify(damaged.mesh, damaged.boxes)) == Rules{"V2"});
}

TEST_CASE("V2 alone fails for a piece that has shrunk inside its triangle") {
  Sound damaged;
  Point& corner = damaged.boxes.corners[0];  // towards the middle of its piece
  corner = midpoint(corner, damaged.boxes.corners[2]);
  CHECK(broken_rules(certify(damaged.mesh, damaged.boxes)) == Rules{"V2"});
}

TEST_CASE("V3 alone fails for a piece that claims a triangle of another region") {
  Sound damaged;
  const VoronoiBox& box = damaged.boxes.boxes.front();
  REQUIRE(box.region == SurfaceId(0U));
  for (std::uint32_t t = 0; t < damaged.mesh.triangle_count(); ++t) {
    if (damaged.mesh.region(TriangleId(t)) == SurfaceId(1U)) {
      damaged.boxes.piece_triangle[box.first_piece] = TriangleId(t);
    }
  }
  CHECK(broken_rules(certify(damaged.mesh, damaged.boxes)) == Rules{"V3"});
}

TEST_CASE("V3 alone fails for a piece that lies in another triangle of its region") {
  Sound damaged;
  const std::uint32_t first = damaged.boxes.boxes.front().first_piece;
  const std::uint32_t last = damaged.boxes.boxes.back().first_piece;
  REQUIRE(damaged.boxes.boxes.front().region != damaged.boxes.boxes.back().region);
  const VertexId far(3U * 5U);  // top of the left side, region 0
  const auto box = std::ranges::find(damaged.boxes.boxes, far, &VoronoiBox::vertex);
  damaged.boxes.piece_triangle[first] = damaged.boxes.piece_triangle[box->first_piece];
  CHECK(broken_rules(certify(damaged.mesh, damaged.boxes)) == Rules{"V3"});
  CHECK(first != last);
}

TEST_CASE("a piece that reaches out of its triangle by 1e-11 of its size fails, by 1e-14 passes") {
  for (const double beyond : {1e-11, 1e-14}) {
    CAPTURE(beyond);
    std::size_t failed = 0;
    const Sound sound;
    for (std::size_t i = 0; i < sound.boxes.corners.size(); ++i) {
      VoronoiBoxes boxes = sound.boxes;
      boxes.corners[i] = boxes.corners[i] + Point{beyond, 0};
      failed += broken_rules(certify(sound.mesh, boxes)).contains("V3");
    }
    if (beyond < 1e-12) CHECK(failed == 0);
    else CHECK(failed > sound.boxes.corners.size() / 10);  // those at a side that faces right
  }
}

TEST_CASE("a corner that is no number fails V3") {
  for (const double x : {std::numeric_limits<double>::quiet_NaN(),
                         std::numeric_limits<double>::infinity(), -1e300}) {
    CAPTURE(x);
    Sound damaged;
    damaged.boxes.corners[1].x = x;
    CHECK(broken_rules(certify(damaged.mesh, damaged.boxes)).contains("V3"));
  }
}

TEST_CASE("the certificate of a mesh is that of its boxes, though it never has all of them") {
  for (const std::uint32_t columns : {1U, 20U, 60U}) {  // 4, 441 and 3721 vertices
    CAPTURE(columns);
    const Mesh mesh = grid({.columns = columns,
                            .rows = columns,
                            .corner = {5e5, 4e6},
                            .jitter = 0.15,
                            .regions = columns == 1 ? 1U : 4U});
    const Certificate at_once = certify(mesh), of_boxes = certify(mesh, voronoi_boxes(mesh));
    CHECK(at_once.summary() == of_boxes.summary());
    CHECK(at_once.summary() == "admissible");
    CHECK(at_once.largest_area_defect == of_boxes.largest_area_defect);
  }
}

TEST_CASE("a mesh that breaks V1 is certified by that alone") {
  const Mesh mesh = two_triangles({-2, 0}, {0, -1}, {2, 0}, {0, 0.5});
  const Certificate certificate = certify(mesh);
  CHECK(broken_rules(certificate) == Rules{"V1"});
  CHECK(certificate.offending.size() == 1);
}

TEST_CASE("V3 alone fails for a box in two halves, and for one too few of no area") {
  Sound split;
  VoronoiBox half = split.boxes.boxes[0];
  REQUIRE(half.pieces == 2);
  const auto twice_area = [&](std::uint32_t i) {
    const auto piece = split.boxes.piece(i);
    double sum = 0;
    for (std::size_t j = 2; j < piece.size(); ++j) {
      sum += cross(piece[j - 1] - piece[0], piece[j] - piece[0]);
    }
    return sum;
  };
  half.pieces = 1;
  half.area = 0.5 * twice_area(half.first_piece);
  split.boxes.boxes[0].first_piece += 1;
  split.boxes.boxes[0].pieces = 1;
  split.boxes.boxes[0].area = 0.5 * twice_area(half.first_piece + 1);
  split.boxes.boxes.insert(split.boxes.boxes.begin(), half);
  CHECK(broken_rules(certify(split.mesh, split.boxes)) == Rules{"V3"});
}

TEST_CASE("V3 fails for an interface vertex whose box is not split") {
  Sound damaged;
  auto& boxes = damaged.boxes.boxes;
  const auto second = std::ranges::adjacent_find(boxes, {}, &VoronoiBox::vertex) + 1;
  boxes.erase(second);
  const Rules rules = broken_rules(certify(damaged.mesh, damaged.boxes));
  CHECK(rules.contains("V3"));
  CHECK_FALSE(rules.contains("V1"));
}

TEST_CASE("boxes of another mesh are refused without a crash") {
  const Certificate certificate = certify(square(), voronoi_boxes(hexagon()));
  CHECK(broken_rules(certificate) == Rules{"V2", "V3"});
  CHECK(broken_rules(certify(square(), VoronoiBoxes{})) == Rules{"V2", "V3"});
}

TEST_CASE("the summary shows the first violations and counts the others") {
  const std::string text = certify(square(), VoronoiBoxes{}).summary();
  CHECK(text.find("V2 surface 1: its boxes cover 0 of its area 1") != std::string::npos);
  CHECK(text.ends_with("; and 2 more"));  // one for the region, four for the vertices
}
