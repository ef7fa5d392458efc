#include "lepp/triangulation/edge_records.hpp"

#include <doctest/doctest.h>

#include <map>
#include <random>

using namespace lepp;

TEST_CASE("edge records behave like a map, whatever is added, replaced and removed") {
  std::mt19937 random(3);
  EdgeRecords records;
  std::map<std::pair<std::uint32_t, std::uint32_t>, EdgeRecords::Record> oracle;
  for (int i = 0; i < 100000; ++i) {
    const auto a = static_cast<std::uint32_t>(random() % 40);
    const auto b = static_cast<std::uint32_t>(40 + random() % 40);
    const bool swapped = random() % 2 != 0;
    const VertexId u(swapped ? b : a), v(swapped ? a : b);
    if (random() % 3 == 0) {
      records.erase(u, v);
      oracle.erase({a, b});
    } else {
      EdgeRecords::Record record{SegmentSetId(static_cast<std::uint32_t>(random() % 1000)), {}};
      if (random() % 2 != 0) record.parameters = {0.25, static_cast<double>(random() % 7)};
      records.set(u, v, record);
      oracle[{a, b}] = record;
    }
    if (i % 1000 != 0) continue;
    REQUIRE(records.size() == oracle.size());
    for (std::uint32_t x = 0; x < 40; ++x) {
      for (std::uint32_t y = 40; y < 80; ++y) {
        const auto found = records.find(VertexId(y), VertexId(x));
        const auto known = oracle.find({x, y});
        REQUIRE(found.has_value() == (known != oracle.end()));
        if (!found) continue;
        REQUIRE(found->segments == known->second.segments);
        REQUIRE(found->parameters == known->second.parameters);
      }
    }
  }
}
