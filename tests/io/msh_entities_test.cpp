#include "lepp/io/msh_entities.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "io/sample_meshes.hpp"

using namespace lepp;

namespace {

const MshCurve* curve_with_tag(const MshEntities& entities, int tag) {
  const auto found = std::ranges::find(entities.curves, tag, &MshCurve::tag);
  return found == entities.curves.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("every constrained edge is a line of its curve, along the curve") {
  const Mesh mesh = test::two_squares_mesh();
  const MshEntities entities = msh_entities(mesh);
  REQUIRE(entities.curves.size() == 7);
  const MshCurve* bottom = curve_with_tag(entities, 11);
  REQUIRE(bottom != nullptr);
  REQUIRE(bottom->lines.size() == 2);  // 0-1 and 1-2
  for (const auto& [a, b] : bottom->lines) CHECK(mesh.point(a).x < mesh.point(b).x);
  CHECK(bottom->ends == std::vector<VertexId>{VertexId(0U), VertexId(2U)});
  CHECK(bottom->is_implied);
  CHECK_FALSE(curve_with_tag(entities, 17)->is_implied);  // the crack
}

TEST_CASE("a surface lists its curves, negative where it lies to their right") {
  const MshEntities entities = msh_entities(test::two_squares_mesh());
  REQUIRE(entities.surfaces.size() == 2);
  const auto boundary = [&](std::size_t i) {
    const auto& list = entities.surfaces[i].boundary;
    return std::set<int>(list.begin(), list.end());
  };
  CHECK(boundary(0) == std::set<int>{11, 14, 15, 16});
  CHECK(boundary(1) == std::set<int>{11, 12, 13, -16});
}

TEST_CASE("a vertex belongs to the entity of lowest dimension around it") {
  const MshEntities entities = msh_entities(test::two_squares_mesh());
  const auto dimension = [&](std::size_t v) { return entities.owner_of_vertex[v].dimension; };
  CHECK(dimension(0) == 0);  // end of curves
  CHECK(dimension(6) == 0);  // a point entity
  CHECK(dimension(7) == 0);  // end of the crack
  CHECK(entities.points[entities.owner_of_vertex[6].index].tag == 31);
  const MshEntities closed = msh_entities(constrained_delaunay(test::square_with_hole()).mesh);
  for (const auto& owner : closed.owner_of_vertex) CHECK(owner.dimension == 1);
}

TEST_CASE("constrained edges of no curve make a curve for the boundary and one for the inside") {
  Pslg pslg = test::square_with_hole();
  pslg.points.insert(pslg.points.end(), {{0.5, 0.25}, {0.5, 2.5}});
  pslg.segments.push_back({VertexId(8U), VertexId(9U), std::nullopt, 0, 1});
  const MshEntities entities = msh_entities(constrained_delaunay(pslg).mesh);
  REQUIRE(entities.curves.size() == 2);
  CHECK(entities.curves[0].lines.size() == 8);
  CHECK(entities.curves[0].ends.empty());  // two closed rings are no open chain
  CHECK(entities.curves[1].lines.size() == 1);
  CHECK(entities.curves[1].ends.size() == 2);
  CHECK(entities.curves[0].tag > 0);
  CHECK(entities.curves[0].tag != entities.curves[1].tag);
}

TEST_CASE("tags that are not positive or taken are replaced by free ones") {
  Pslg pslg = test::two_squares();
  pslg.entities.curves[0].tag = -3;
  pslg.entities.curves[1].tag = 13;  // as curve 13 of the sample
  pslg.entities.surfaces[1].tag = 21;
  const MshEntities entities = msh_entities(constrained_delaunay(pslg).mesh);
  std::set<int> tags;
  for (const MshCurve& c : entities.curves) {
    CHECK(c.tag > 0);
    tags.insert(c.tag);
  }
  CHECK(tags.size() == entities.curves.size());
  CHECK(entities.surfaces[0].tag == 21);
  CHECK(entities.surfaces[1].tag == 1);
}

TEST_CASE("overlapping segments of two curves give each curve its line") {
  Pslg pslg = test::two_squares();
  pslg.segments.push_back({VertexId(4U), VertexId(1U), CurveId(6U), 0, 1});  // 16 again, backwards
  const MshEntities entities = msh_entities(constrained_delaunay(pslg).mesh);
  REQUIRE(curve_with_tag(entities, 16)->lines.size() == 1);
  REQUIRE(curve_with_tag(entities, 17)->lines.size() == 2);
  CHECK(curve_with_tag(entities, 16)->lines[0].a == VertexId(1U));
  const auto& lines = curve_with_tag(entities, 17)->lines;
  CHECK(std::ranges::any_of(lines, [](const MshLine& line) { return line.a == VertexId(4U); }));
}

TEST_CASE("nothing stays ungrouped beside groups, and nothing is grouped without them") {
  Pslg pslg = test::two_squares();
  pslg.entities.surfaces[1].groups.clear();
  pslg.entities.curves[4].groups.clear();  // implied: between mesh and outside
  MshEntities entities = msh_entities(constrained_delaunay(pslg).mesh);
  leave_nothing_ungrouped(entities);
  REQUIRE(entities.groups.size() == 10);
  CHECK(entities.groups[8].name == "ungrouped");
  CHECK(entities.groups[8].dimension == 1);
  CHECK(entities.groups[8].tag == 5);
  CHECK(curve_with_tag(entities, 17)->groups == std::vector<GroupId>{GroupId(8U)});
  CHECK_FALSE(curve_with_tag(entities, 15)->is_written);
  CHECK(entities.surfaces[1].groups == std::vector<GroupId>{GroupId(9U)});
  MshEntities plain = msh_entities(constrained_delaunay(test::square_with_hole()).mesh);
  leave_nothing_ungrouped(plain);
  CHECK(plain.groups.empty());
  CHECK(plain.curves[0].is_written);
}
