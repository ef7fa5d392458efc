#include "lepp/io/gmsh_record.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace lepp;

namespace {

GmshRecord sample() {
  GmshRecord record;
  record.warnings = {"careful"};
  record.groups = {{1, 7, "wall"}};
  record.points = {{3, {0.5, -2}, 0.25, {7, 8}}};
  GmshCurve curve;
  curve.tag = 4;
  curve.geometry = CubicPieces{{0, 0.5, 1}, {{}, {Point{1, 2}, {3, 4}, {5, 6}, {7, 8}}}};
  curve.inner = {{{1, 1}, 0.5}};
  record.curves = {curve};
  record.curves.push_back({5, 1, 2, {}, EllipseArc{{1, 2}, {3, 4}, {5, 6}, 7, 8}, 0, 1, 2, {}});
  record.surfaces = {{9, {1}, {4, 5, 4}, {3}, {5}, -1, 1}};
  record.mesh = GmshMesh{{10, 5'000'000'000}, {0, 1, 2, 3, 4, 5}, {{6, {0, 1, 0}, 9}}, {}, {}};
  return record;
}

}  // namespace

TEST_CASE("a record survives the pipe") {
  const auto read = decode_gmsh_record(encode(sample()));
  REQUIRE(read);
  CHECK(read->warnings == sample().warnings);
  CHECK(read->groups[0].name == "wall");
  CHECK(read->points[0].position == Point{0.5, -2});
  CHECK(read->points[0].groups == std::vector<int>{7, 8});
  CHECK(std::get<CubicPieces>(read->curves[0].geometry).pieces[1][3] == Point{7, 8});
  CHECK(std::get<EllipseArc>(read->curves[1].geometry).sweep == 8);
  CHECK(read->surfaces[0].boundary == std::vector<int>{4, 5, 4});
  CHECK(read->mesh->node_tags[1] == 5'000'000'000);
  CHECK(read->mesh->triangles[0].surface == 9);
  CHECK(!read->failure);
}

TEST_CASE("no cut or damaged record is taken for a record") {
  const std::vector<std::byte> good = encode(sample());
  for (std::size_t n = 0; n < good.size(); ++n)
    CHECK_FALSE(decode_gmsh_record(std::span(good).first(n)));
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::vector<std::byte> bad = good;
    bad[i] ^= std::byte{1};
    CHECK_FALSE(decode_gmsh_record(bad));
  }
}
