// SPDX-License-Identifier: GPL-2.0-or-later
#include "boundary_points.hpp"

#include <gmsh.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace lepp::gmsh_helper {
namespace {

constexpr double most_points = 1e6;

struct Nodes {
  std::vector<double> coordinates, parameters;
};

Nodes nodes_inside(int curve) {
  std::vector<std::size_t> tags;
  Nodes nodes;
  gmsh::model::mesh::getNodes(tags, nodes.coordinates, nodes.parameters, 1, curve, false, true);
  return nodes;
}

std::string text_of(double value) {
  std::array<char, 32> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 3);
  return {text.data(), end.ptr};
}

class Generator {
 public:
  explicit Generator(GmshRecord& record) : record_(record) {
    gmsh::option::getNumber("Mesh.MeshSizeFactor", own_factor_);
    for (const GmshCurve& curve : record.curves) length_ += curve.length;
  }

  void run() {
    // Transfinite curves and the least number of points on a circle do not depend on the factor.
    const double fixed = points_with(1e12);
    for (const double factor : {1e9, 1e6, 1e4, 1e3, 1e2, 1e1}) {
      const double counted = points_with(factor) - fixed;
      constexpr double enough_to_count = 8;
      const double predicted = fixed + counted * factor;
      if (counted >= enough_to_count && predicted > most_points) refuse(predicted);
    }
    if (const double points = points_with(1); points > most_points) refuse(points);
    for (GmshCurve& curve : record_.curves) take_points(curve);
  }

 private:
  double points_with(double factor) {
    gmsh::model::mesh::clear();
    gmsh::option::setNumber("Mesh.MeshSizeFactor", own_factor_ * factor);
    gmsh::model::mesh::generate(1);
    std::size_t count = 0;
    for (const GmshCurve& curve : record_.curves)
      count += nodes_inside(curve.tag).parameters.size();
    return static_cast<double>(count);
  }

  [[noreturn]] void refuse(double points) const {
    throw GmshFailure{
        ErrorKind::refused, "",
        "its mesh sizes (" + text_of(length_ / points) + " on average along curves " +
            text_of(length_) + " long) ask for about " + text_of(points) +
            " boundary points, more than " + text_of(most_points),
        "use larger sizes, or remove them: without sizes the mesh is as coarse as its "
        "angles allow"};
  }

  /// Gmsh lists the points in any order; on a copy of another curve they run backwards.
  static void take_points(GmshCurve& curve) {
    std::vector<double> low, high;
    gmsh::model::getParametrizationBounds(1, curve.tag, low, high);
    const Nodes nodes = nodes_inside(curve.tag);
    for (std::size_t i = 0; i < nodes.parameters.size(); ++i) {
      const double t = (nodes.parameters[i] - low.at(0)) / (high.at(0) - low.at(0));
      if (!(t > 0 && t < 1)) continue;
      curve.inner.push_back({{nodes.coordinates[3 * i], nodes.coordinates[3 * i + 1]}, t});
    }
    const auto by_parameter = [](const CurvePoint& a, const CurvePoint& b) { return a.t < b.t; };
    const auto same_parameter = [](const CurvePoint& a, const CurvePoint& b) { return a.t == b.t; };
    auto& inner = curve.inner;
    std::sort(inner.begin(), inner.end(), by_parameter);
    inner.erase(std::unique(inner.begin(), inner.end(), same_parameter), inner.end());
  }

  GmshRecord& record_;
  double own_factor_ = 1;
  double length_ = 0;
};

}  // namespace

void add_own_points(GmshRecord& record) {
  Generator(record).run();
  record.own_points = true;
}

}  // namespace lepp::gmsh_helper
