#include "lepp/triangulation/components.hpp"

#include <doctest/doctest.h>

#include <random>

#include "lepp/triangulation/delaunay.hpp"
#include "lepp/triangulation/spatial_order.hpp"

using namespace lepp;

namespace {

using Code = RawTriangulation::Code;

// A triangulation of random points with `percent` of its edges constrained.
RawTriangulation with_walls(std::uint64_t seed, std::size_t count, unsigned percent) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back({uniform(random), uniform(random)});
  RawTriangulation raw;
  for (const std::uint32_t i : spatial_order(points)) raw.points.push_back(points[i]);
  REQUIRE(triangulate_points(raw));
  for (std::uint32_t t = 0; t < raw.triangles.size(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Code e = RawTriangulation::code(t, i);
      const bool to_infinity = raw.is_ghost(t) && i != 2;
      if (!to_infinity && raw.twin(e) > e && random() % 100 < percent) raw.constrain(e);
    }
  }
  return raw;
}

// By the definition: a stack, one component after the other.
struct Plain {
  std::vector<std::uint32_t> labels;  // by triangle, 0 for ghosts
  std::vector<bool> is_open;          // by label - 1
  bool one_lies_across_the_middle = false;
};

Plain plain_components(const RawTriangulation& raw) {
  Plain plain;
  const auto count = static_cast<std::uint32_t>(raw.triangles.size());
  plain.labels.assign(count, 0);
  for (std::uint32_t start = 0; start < count; ++start) {
    if (raw.is_ghost(start) || plain.labels[start] != 0) continue;
    plain.is_open.push_back(false);
    const auto label = static_cast<std::uint32_t>(plain.is_open.size());
    std::vector<std::uint32_t> stack{start};
    plain.labels[start] = label;
    while (!stack.empty()) {  // each triangle enters once
      const std::uint32_t t = stack.back();
      stack.pop_back();
      if (start < count / 2 && t >= count / 2) plain.one_lies_across_the_middle = true;
      for (std::uint32_t i = 0; i < 3; ++i) {
        const Code e = RawTriangulation::code(t, i);
        const std::uint32_t across = RawTriangulation::triangle_of(raw.twin(e));
        if (raw.is_constrained(e)) continue;
        if (raw.is_ghost(across)) {
          plain.is_open.back() = true;
        } else if (plain.labels[across] == 0) {
          plain.labels[across] = label;
          stack.push_back(across);
        }
      }
    }
  }
  return plain;
}

}  // namespace

TEST_CASE("components and their order are those of a plain flood, with one thread or two") {
  std::size_t across = 0;
  for (const unsigned percent : {0U, 20U, 50U, 60U, 70U, 90U, 100U}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      CAPTURE(percent);
      CAPTURE(seed);
      for (const unsigned threads : {1U, 2U}) {
        RawTriangulation raw = with_walls(seed, 3 + 40 * seed, percent);
        const Plain plain = plain_components(raw);
        const Components found = label_components(raw, threads);
        CHECK(found.count == plain.is_open.size());
        CHECK(found.is_open == plain.is_open);
        std::size_t different = 0;
        for (std::uint32_t t = 0; t < raw.triangles.size(); ++t) {
          if (raw.label(t) != plain.labels[t]) ++different;
        }
        CHECK(different == 0);
        if (plain.one_lies_across_the_middle) ++across;
      }
    }
  }
  CHECK(across > 150);  // of 280: labels of the two halves of the array were joined
}
