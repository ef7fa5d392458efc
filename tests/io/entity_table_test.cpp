#include "lepp/io/entity_table.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace lepp;

TEST_CASE("equal markers are one curve, equal attributes and limits one surface") {
  EntityTable table;
  CHECK(table.curve(5) == table.curve(5));
  CHECK(table.curve(5) != table.curve(-5));
  CHECK(table.surface(1, 0.5) == table.surface(1, 0.5));
  CHECK(table.surface(1, 0.5) != table.surface(1, 0.25));
  CHECK(table.surface(1, 0.5) != table.surface(2, 0.5));
  const Entities entities = table.finish();
  CHECK(entities.curves.size() == 2);
  CHECK(entities.surfaces.size() == 3);
}

TEST_CASE("attributes that are no tags get the free ones, equal attributes the same") {
  EntityTable table;
  const double none = std::numeric_limits<double>::infinity();
  for (const double attribute : {0.5, 1.0, 1e300, 3.0, -0.25, -2.0, 0.0}) {
    table.surface(attribute, none);
  }
  table.surface(0.5, 7);
  const Entities entities = table.finish();
  std::vector<int> tags;
  for (const SurfaceEntity& s : entities.surfaces) tags.push_back(s.tag);
  CHECK(tags == std::vector<int>{2, 1, 4, 3, 5, -2, 0, 2});
  CHECK(entities.surfaces.front().groups == entities.surfaces.back().groups);
}
