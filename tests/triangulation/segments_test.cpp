// Inputs on which segment insertion is quadratic where it is done without care. There is no clock
// here: at these sizes a quadratic step takes minutes, and the time limit of the test ends it.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "lepp/triangulation/validate.hpp"

using namespace lepp;

namespace {

constexpr std::size_t many = 50000;

void add_segment(Pslg& pslg, std::size_t a, std::size_t b) {
  pslg.segments.push_back({VertexId(a), VertexId(b), {}, 0, 1});
}

void check(const Pslg& pslg) {
  const Triangulation made = constrained_delaunay(pslg);
  CHECK(validate(made.mesh).summary() == "valid");
}

}  // namespace

TEST_CASE("a segment between two long rows of points") {
  Pslg pslg;
  pslg.points = {{-1, 0}, {static_cast<double>(many) + 1, 0}};
  for (std::size_t i = 0; i < many; ++i) {
    pslg.points.push_back({static_cast<double>(i), 1});
    pslg.points.push_back({static_cast<double>(i) + 0.3, -1});
  }
  add_segment(pslg, 0, 1);
  check(pslg);
}

TEST_CASE("a chord through a smooth closed curve, along its longer and its shorter axis") {
  for (const double flat : {0.3, 3.0}) {
    Pslg pslg;
    for (std::size_t i = 0; i < many; ++i) {
      const double turn = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(many);
      pslg.points.push_back({std::cos(turn), flat * std::sin(turn)});
      add_segment(pslg, i, (i + 1) % many);
    }
    add_segment(pslg, 0, many / 2);
    check(pslg);
  }
}

TEST_CASE("a hub with a segment to every point of a circle") {
  Pslg pslg;
  pslg.points.push_back({0, 0});
  for (std::size_t i = 0; i < many; ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(many);
    pslg.points.push_back({std::cos(turn), std::sin(turn)});
    add_segment(pslg, 0, i + 1);
  }
  check(pslg);
}

TEST_CASE("a segment across the tips of a comb, and one through the arms of a spiral") {
  Pslg comb;
  for (std::size_t i = 0; i < many / 2; ++i) {
    comb.points.push_back({static_cast<double>(i), 0});
    comb.points.push_back({static_cast<double>(i) + 0.5, 1000});
  }
  for (std::size_t i = 0; i + 1 < many; ++i) add_segment(comb, i, i + 1);
  comb.points.push_back({-1, 1000.5});
  comb.points.push_back({static_cast<double>(many), 1000.5});
  add_segment(comb, many, many + 1);
  check(comb);

  Pslg spiral;
  for (std::size_t i = 0; i < many; ++i) {
    const double turn = 0.05 * static_cast<double>(i), radius = 1 + turn;
    spiral.points.push_back({radius * std::cos(turn), radius * std::sin(turn)});
    if (i > 0) add_segment(spiral, i - 1, i);
  }
  check(spiral);
}

TEST_CASE("a parabola: circles through neighbouring points are nested") {
  Pslg pslg;
  for (std::size_t i = 0; i < many; ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(many);
    pslg.points.push_back({x, x * x});
    if (i > 0) add_segment(pslg, i - 1, i);
  }
  pslg.points.push_back({1.0, 1.0});
  pslg.points.push_back({0.5, 2.0});
  add_segment(pslg, 0, many + 1);
  check(pslg);
}

TEST_CASE("copies of one segment: their edge has one set of owners, ascending, and no other set") {
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {0, 1}};
  for (std::size_t i = 0; i < 3; ++i) add_segment(pslg, i, (i + 1) % 3);
  for (std::size_t i = 0; i < many; ++i) add_segment(pslg, i % 2, 1 - i % 2);
  const Mesh mesh = constrained_delaunay(pslg).mesh;
  CHECK(validate(mesh).summary() == "valid");
  const auto shared = mesh.find_edge(VertexId(0U), VertexId(1U));
  REQUIRE(shared);
  CHECK(mesh.segments_of(*shared).size() == many + 1);
  CHECK(std::ranges::is_sorted(mesh.segments_of(*shared)));
  CHECK(mesh.constrained_edge(*shared).segments == SegmentSetId(mesh.segments().size()));
}

TEST_CASE("nested segments over many points are refused before their pieces fill the memory") {
  Pslg pslg;
  pslg.points = {{0, -1}};
  for (std::size_t i = 0; i < many; ++i) pslg.points.push_back({static_cast<double>(i), 0});
  for (std::size_t i = 1; i < 2000; ++i) add_segment(pslg, i, many + 1 - i);
  std::string message;
  try {
    constrained_delaunay(pslg);
  } catch (const RefusedError& error) {
    message = error.what();
  }
  CHECK(message.find("more than 10 million") != std::string::npos);
}
