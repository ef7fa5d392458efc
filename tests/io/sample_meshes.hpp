#pragma once

// Meshes with groups of every dimension, for the tests of writers.

#include "lepp/triangulation/constrained_delaunay.hpp"

namespace lepp::test {

///   5 ---(14)--- 4 ---(13)--- 3      two unit squares: region 1 "left" on the left, 2 on the right
///   |            |            |      6 is a point of its own in the middle of the right square,
///  (15)        (16)    6    (12)     7-8 a crack inside the left one (curve 17, no group)
///   |   7--8     |            |      curves 11 to 14 in group "outside", 16 in "interface" and
///   0 ---(11)--- 1 ---(11)--- 2      "sensor", 15 in "inlet"; both surfaces in "plate" too
inline Pslg two_squares() {
  Pslg pslg;
  pslg.source = "two squares";
  pslg.points = {{0, 0}, {1, 0},     {2, 0},      {2, 1},    {1, 1},
                 {0, 1}, {1.5, 0.5}, {0.25, 0.5}, {0.5, 0.5}};
  Entities& entities = pslg.entities;
  entities.groups = {{2, 1, "left"},  {2, 2, "right"},     {2, 3, "plate"}, {1, 1, "outside"},
                     {1, 2, "inlet"}, {1, 3, "interface"}, {1, 4, ""},      {0, 9, "well"}};
  const auto groups = [](std::initializer_list<std::uint32_t> ids) {
    std::vector<GroupId> list;
    for (const std::uint32_t id : ids) list.emplace_back(id);
    return list;
  };
  entities.curves = {
      {11, groups({3}), StraightCurve{}, {}}, {12, groups({3}), StraightCurve{}, {}},
      {13, groups({3}), StraightCurve{}, {}}, {14, groups({3}), StraightCurve{}, {}},
      {15, groups({4}), StraightCurve{}, {}}, {16, groups({5, 6}), StraightCurve{}, {}},
      {17, {}, StraightCurve{}, {}}};
  entities.surfaces = {{21, groups({0, 2}), 1, 0.25}, {22, groups({1, 2}), 2.5, 1e300}};
  entities.points = {{31, VertexId(6U), groups({7})}};
  const auto segment = [&](std::uint32_t a, std::uint32_t b, std::uint32_t curve) {
    pslg.segments.push_back({VertexId(a), VertexId(b), CurveId(curve), 0, 1});
  };
  segment(0, 1, 0);
  segment(1, 2, 0);
  segment(2, 3, 1);
  segment(3, 4, 2);
  segment(4, 5, 3);
  segment(5, 0, 4);
  segment(1, 4, 5);
  segment(7, 8, 6);
  pslg.seeds = {{{0.1, 0.1}, SurfaceId(0U)}, {{1.9, 0.1}, SurfaceId(1U)}};
  return pslg;
}

inline Mesh two_squares_mesh() { return constrained_delaunay(two_squares()).mesh; }

/// The square [0,3]^2 with the hole [1,2]^2; no tags at all.
inline Pslg square_with_hole() {
  Pslg pslg;
  pslg.source = "square with hole";
  pslg.points = {{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {2, 1}, {2, 2}, {1, 2}};
  for (std::uint32_t i = 0; i < 8; ++i) {
    const std::uint32_t next = i % 4 == 3 ? i - 3 : i + 1;
    pslg.segments.push_back({VertexId(i), VertexId(next), std::nullopt, 0, 1});
  }
  pslg.holes = {{1.5, 1.5}};
  return pslg;
}

}  // namespace lepp::test
