// SPDX-License-Identifier: GPL-2.0-or-later
#include "read_geometry.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "lepp/io/gmsh_curve_fit.hpp"

namespace lepp::gmsh_helper {
namespace {

std::vector<int> tags_of(int dimension) {
  gmsh::vectorpair entities;
  gmsh::model::getEntities(entities, dimension);
  std::vector<int> tags;
  for (const auto& entity : entities) tags.push_back(entity.second);
  return tags;
}

/// Tags of the entities one dimension lower, once per occurrence.
std::vector<int> boundary_of(int dimension, int tag) {
  gmsh::vectorpair boundary;
  gmsh::model::getBoundary({{dimension, tag}}, boundary, false, false, false);
  std::vector<int> tags;
  for (const auto& entity : boundary) tags.push_back(std::abs(entity.second));
  return tags;
}

void refuse_discrete(int dimension, int tag) {
  std::string type;
  gmsh::model::getType(dimension, tag, type);
  if (!type.starts_with("Discrete")) return;
  throw GmshFailure{ErrorKind::input,
                    (dimension == 1 ? "curve " : "surface ") + std::to_string(tag),
                    "is a mesh without geometry",
                    "give the .msh file itself, or describe the geometry in the .geo file"};
}

GmshPoint point_of(int tag) {
  std::vector<double> xyz;
  gmsh::model::getValue(0, tag, {}, xyz);
  return {tag, {xyz.at(0), xyz.at(1)}, xyz.at(2), groups_of(0, tag)};
}

/// Evaluates a curve at parameters scaled to [0, 1] and remembers the range of z.
class Evaluator {
 public:
  explicit Evaluator(int curve) : curve_(curve) {
    std::vector<double> low, high;
    gmsh::model::getParametrizationBounds(1, curve, low, high);
    low_ = low.at(0);
    high_ = high.at(0);
  }

  std::vector<Point> operator()(std::span<const double> parameters) {
    std::vector<double> scaled, xyz;
    for (const double t : parameters) scaled.push_back(low_ + t * (high_ - low_));
    gmsh::model::getValue(1, curve_, scaled, xyz);
    std::vector<Point> points;
    for (std::size_t i = 0; i + 2 < xyz.size(); i += 3) {
      points.push_back({xyz[i], xyz[i + 1]});
      z_low = std::min(z_low, xyz[i + 2]);
      z_high = std::max(z_high, xyz[i + 2]);
    }
    if (points.size() != parameters.size())
      throw GmshFailure{ErrorKind::input, "curve " + std::to_string(curve_),
                        "Gmsh cannot evaluate it", "replace it by another kind of curve"};
    return points;
  }

  double z_low = HUGE_VAL, z_high = -HUGE_VAL;

 private:
  int curve_;
  double low_ = 0, high_ = 1;
};

double length_of(Evaluator& evaluate) {
  std::vector<double> t;
  for (int i = 0; i <= 64; ++i) t.push_back(i / 64.0);
  const std::vector<Point> points = evaluate(t);
  double sum = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    sum += std::sqrt(squared_distance(points[i], points[i + 1]));
  return sum;
}

GmshCurve curve_of(int tag) {
  refuse_discrete(1, tag);
  GmshCurve curve;
  curve.tag = tag;
  curve.groups = groups_of(1, tag);
  const std::vector<int> ends = boundary_of(1, tag);
  if (ends.empty())
    throw GmshFailure{ErrorKind::input, "curve " + std::to_string(tag), "has no end points",
                      "put a point on it"};
  Evaluator evaluate(tag);
  curve.begin = ends.front();
  curve.end = ends.back();
  const std::vector<Point> reached = evaluate(std::vector<double>{0, 1});
  const Point begin = point_of(curve.begin).position, end = point_of(curve.end).position;
  const auto mismatch = [&](Point a, Point b) {
    return squared_distance(a, reached[0]) + squared_distance(b, reached[1]);
  };
  if (mismatch(end, begin) < mismatch(begin, end)) std::swap(curve.begin, curve.end);
  curve.geometry = fit_curve([&](std::span<const double> t) { return evaluate(t); });
  curve.length = length_of(evaluate);
  curve.z_low = evaluate.z_low;
  curve.z_high = evaluate.z_high;
  return curve;
}

/// Heights of a surface that is not called plane: its boundary may be plane all the same.
void sample_heights(GmshSurface& surface) {
  std::string type;
  gmsh::model::getType(2, surface.tag, type);
  if (type == "Plane") return;
  std::vector<double> low, high, parameters, xyz;
  gmsh::model::getParametrizationBounds(2, surface.tag, low, high);
  constexpr int steps = 4;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j) {
      parameters.push_back(low.at(0) + (high.at(0) - low.at(0)) * i / steps);
      parameters.push_back(low.at(1) + (high.at(1) - low.at(1)) * j / steps);
    }
  gmsh::model::getValue(2, surface.tag, parameters, xyz);
  for (std::size_t i = 2; i < xyz.size(); i += 3) {
    if (i == 2) surface.z_low = surface.z_high = xyz[i];
    surface.z_low = std::min(surface.z_low, xyz[i]);
    surface.z_high = std::max(surface.z_high, xyz[i]);
  }
}

GmshSurface surface_of(int tag) {
  refuse_discrete(2, tag);
  GmshSurface surface;
  surface.tag = tag;
  surface.groups = groups_of(2, tag);
  surface.boundary = boundary_of(2, tag);
  gmsh::vectorpair embedded;
  gmsh::model::mesh::getEmbedded(2, tag, embedded);
  for (const auto& [dimension, entity] : embedded) {
    if (dimension == 0) surface.embedded_points.push_back(entity);
    if (dimension == 1) surface.embedded_curves.push_back(entity);
  }
  if (!surface.boundary.empty()) {
    std::vector<double> xyz;
    gmsh::model::getValue(0, boundary_of(1, surface.boundary[0]).at(0), {}, xyz);
    surface.z_low = surface.z_high = xyz.at(2);
  }
  sample_heights(surface);
  return surface;
}

/// A closed B-spline of Gmsh does not pass through the point that it begins and ends at. If nobody
/// else has that point, it is moved onto the curve; otherwise the curve cannot be used.
void put_ends_on(const GmshCurve& curve, GmshRecord& record) {
  if (is_straight(curve.geometry)) return;
  for (const auto& [tag, t] : {std::pair{curve.begin, 0.0}, std::pair{curve.end, 1.0}}) {
    const auto point = std::find_if(record.points.begin(), record.points.end(),
                                    [tag = tag](const GmshPoint& p) { return p.tag == tag; });
    const Point reached = point_at(curve.geometry, t);
    const double off = std::sqrt(squared_distance(reached, point->position));
    if (off <= 1e-8 * curve.length) continue;
    const auto users =
        std::count_if(record.curves.begin(), record.curves.end(),
                      [tag = tag](const GmshCurve& c) { return c.begin == tag || c.end == tag; });
    if (users > 1 || curve.begin != curve.end)
      throw GmshFailure{ErrorKind::input, "curve " + std::to_string(curve.tag),
                        "it does not pass through its end point " + std::to_string(tag),
                        "use a Spline, or a BSpline that is not closed"};
    point->position = reached;
    record.warnings.push_back("curve " + std::to_string(curve.tag) +
                              " does not pass through its point " + std::to_string(tag) +
                              ": the point is moved onto the curve");
  }
}

}  // namespace

void add_groups(GmshRecord& record) {
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups);
  for (const auto& [dimension, tag] : groups) {
    std::string name;
    gmsh::model::getPhysicalName(dimension, tag, name);
    record.groups.push_back({dimension, tag, name});
  }
}

std::vector<int> groups_of(int dimension, int tag) {
  std::vector<int> groups;
  gmsh::model::getPhysicalGroupsForEntity(dimension, tag, groups);
  for (int& group : groups) group = std::abs(group);  // a sign only turns elements around
  std::sort(groups.begin(), groups.end());
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  return groups;
}

void add_geometry(GmshRecord& record) {
  for (const int tag : tags_of(0)) record.points.push_back(point_of(tag));
  for (const int tag : tags_of(1)) record.curves.push_back(curve_of(tag));
  for (const int tag : tags_of(2)) record.surfaces.push_back(surface_of(tag));
  for (const GmshCurve& curve : record.curves) put_ends_on(curve, record);
}

}  // namespace lepp::gmsh_helper
