#pragma once

#include <numbers>

#include "lepp/triangulation/constrained_delaunay.hpp"
#include "support/shapes.hpp"

namespace lepp::test {

///  y
///  2.1 +----+   7  6   two squares; the upper side of the lower one, 2-3, is the chord of an arch
///      |    |          that rises to 1.2, into the upper one: cut there, the mesh overlaps itself
///  1.1 +----+   4  5
///  1   +----+   3  2
///  0   +----+   0  1
inline Mesh blocks_below_an_arch() {
  Pslg pslg = unit_square();
  add_chain(pslg, {{0, 1.1}, {1, 1.1}, {1, 2.1}, {0, 2.1}}, true);
  const EllipseArc arch{{0.5, 1}, {0.5, 0}, {0, 0.2}, 0, std::numbers::pi};
  pslg.entities.curves = {{1, {}, arch, {}}};
  pslg.segments[2].curve = CurveId(0U);
  return constrained_delaunay(pslg).mesh;
}

}  // namespace lepp::test
