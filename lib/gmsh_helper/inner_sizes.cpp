// SPDX-License-Identifier: GPL-2.0-or-later
#include "inner_sizes.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace lepp::gmsh_helper {
namespace {

// Gmsh's own value for "no size".
constexpr double no_size = 1e21;

double option(const std::string& name) {
  double value = 0;
  gmsh::option::getNumber(name, value);
  return value;
}

std::set<int> embedded_points(const GmshRecord& record) {
  std::set<int> points;
  for (const GmshSurface& surface : record.surfaces)
    points.insert(surface.embedded_points.begin(), surface.embedded_points.end());
  for (const GmshCurve& curve : record.curves) {
    points.erase(curve.begin);
    points.erase(curve.end);
  }
  return points;
}

/// A straight curve from a point to a copy of it far away, to be measured.
struct Probe {
  Point position;
  int curve = 0;
};

Probe make_probe(const GmshPoint& point, double length) {
  gmsh::vectorpair copy;
  gmsh::model::geo::copy({{0, point.tag}}, copy);
  gmsh::model::geo::translate(copy, length, 0, 0);
  return {point.position, gmsh::model::geo::addLine(point.tag, copy.at(0).second)};
}

double pieces_of(int curve) {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters, 1, curve, false, false);
  return static_cast<double>(tags.size()) + 1;
}

double extent(const GmshRecord& record) {
  Point low = record.points.at(0).position, high = low;
  for (const auto& [tag, p, z, groups] : record.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return std::sqrt(squared_distance(low, high));
}

/// Few pieces tell little, many take long: the largest factor for all sizes that gives enough of
/// them decides. Probes are so long that factors below 1 are not needed.
void measure(std::vector<Probe> probes, double length, GmshRecord& record) {
  constexpr double enough = 30;
  const double own_factor = option("Mesh.MeshSizeFactor");
  for (double factor = 0x1p30; factor >= 1 && !probes.empty(); factor /= 8) {
    gmsh::model::mesh::clear();
    gmsh::option::setNumber("Mesh.MeshSizeFactor", own_factor * factor);
    gmsh::model::mesh::generate(1);
    std::erase_if(probes, [&](const Probe& probe) {
      const double pieces = pieces_of(probe.curve);
      if (pieces < enough) return false;
      record.inner_sizes.push_back({probe.position, length / (pieces * factor)});
      gmsh::model::geo::remove({{1, probe.curve}});
      return true;
    });
    gmsh::model::geo::synchronize();
  }
}

void measure_points(GmshRecord& record) {
  const std::set<int> embedded = embedded_points(record);
  if (embedded.empty()) return;
  const double length = 40 * extent(record);
  std::vector<Probe> probes;
  for (const GmshPoint& point : record.points) {
    if (embedded.contains(point.tag)) probes.push_back(make_probe(point, length));
  }
  gmsh::model::geo::synchronize();
  measure(std::move(probes), length, record);
}

}  // namespace

void add_inner_sizes(GmshRecord& record) {
  const double largest = option("Mesh.MeshSizeMax") * option("Mesh.MeshSizeFactor");
  if (largest > 0 && largest < no_size) record.largest_size = largest;
  try {
    measure_points(record);
  } catch (...) {  // points of OpenCASCADE; sizes that Gmsh cannot use outside the domain
    record.inner_sizes.clear();
    record.warnings.push_back(
        "the sizes of points inside surfaces, if they have any, cannot be read; give them with "
        "--size-file");
  }
}

}  // namespace lepp::gmsh_helper
