#include "lepp/triangulation/quality.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lepp/geometry/compensated_sum.hpp"
#include "lepp/geometry/predicates.hpp"
#include "lepp/geometry/triangle_measures.hpp"

namespace lepp {

namespace {

constexpr double forgiven_deg = 1e-9;

void count(Quality::Count& counter, bool exact, bool tolerant) {
  counter.exact += exact;
  counter.tolerant += tolerant;
}

using Corners = std::array<Point, 3>;

double angle_deg(const Corners& p, std::uint32_t i) {
  const Point u = p[next_corner(i)] - p[i], w = p[previous_corner(i)] - p[i];
  return std::atan2(std::abs(cross(u, w)), dot(u, w)) * (180 / std::numbers::pi);
}

struct Obtuse {
  bool exact = false, tolerant = false;
};

Obtuse obtuse_at(const Corners& p, std::uint32_t i) {
  static const double tangent = std::tan(forgiven_deg * (std::numbers::pi / 180));
  const Point a = p[next_corner(i)], b = p[previous_corner(i)];
  if (!is_obtuse(a, p[i], b)) return {};
  const Point u = a - p[i], w = b - p[i];
  return {true, -dot(u, w) > tangent * std::abs(cross(u, w))};
}

// One pass over triangles and edges.
class Measurer {
 public:
  explicit Measurer(const Mesh& mesh) : mesh_(mesh), smallest_(180) {}

  Quality measure();

 private:
  void measure_triangle(TriangleId t);
  void measure_angles(const Corners& p);
  void measure_delaunay(const Corners& p, HalfEdge e, HalfEdge across);

  const Mesh& mesh_;
  Quality quality_;
  double smallest_, largest_ = 0;
  CompensatedSum smallest_sum_, largest_sum_;
};

Quality Measurer::measure() {
  const std::size_t n = mesh_.triangle_count();
  for (std::size_t t = 0; t < n; ++t) measure_triangle(TriangleId(t));
  quality_.vertices = mesh_.vertex_count();
  quality_.triangles = n;
  if (n == 0) return quality_;
  quality_.min_angle_deg = smallest_;
  quality_.max_angle_deg = largest_;
  quality_.mean_min_angle_deg = smallest_sum_.value() / static_cast<double>(n);
  quality_.mean_max_angle_deg = largest_sum_.value() / static_cast<double>(n);
  return quality_;
}

void Measurer::measure_triangle(TriangleId t) {
  const Corners p = mesh_.corners(t);
  measure_angles(p);
  Obtuse triangle;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge e{t, i};
    const Obtuse here = obtuse_at(p, i);
    triangle.exact |= here.exact;
    triangle.tolerant |= here.tolerant;
    if (mesh_.is_constrained(e)) count(quality_.obtuse_constrained, here.exact, here.tolerant);
    const auto across = mesh_.twin(e);
    if (!across) count(quality_.obtuse_boundary, here.exact, here.tolerant);
    else if (e < *across) measure_delaunay(p, e, *across);
  }
  count(quality_.obtuse_triangles, triangle.exact, triangle.tolerant);
}

// The smallest angle is opposite the shortest side, the largest opposite the longest: two arc
// tangents, not three.
void Measurer::measure_angles(const Corners& p) {
  const std::array<double, 3> opposite{squared_distance(p[1], p[2]), squared_distance(p[2], p[0]),
                                       squared_distance(p[0], p[1])};
  const auto [shortest, longest] = std::ranges::minmax_element(opposite);
  const double smallest = angle_deg(p, static_cast<std::uint32_t>(shortest - opposite.begin()));
  const double largest = angle_deg(p, static_cast<std::uint32_t>(longest - opposite.begin()));
  smallest_ = std::min(smallest_, smallest);
  largest_ = std::max(largest_, largest);
  smallest_sum_.add(smallest);
  largest_sum_.add(largest);
}

void Measurer::measure_delaunay(const Corners& p, HalfEdge e, HalfEdge across) {
  if (incircle(p[0], p[1], p[2], mesh_.point(mesh_.apex(across))) <= 0) return;
  const double sum_deg =
      angle_deg(p, e.edge) + angle_deg(mesh_.corners(across.triangle), across.edge);
  auto& counter =
      mesh_.is_constrained(e) ? quality_.non_delaunay_constrained : quality_.non_delaunay_edges;
  count(counter, true, sum_deg > 180 + forgiven_deg);
}

// So that an edge is visited once: from the side whose triangle comes first.
bool is_first_side(const Mesh& mesh, HalfEdge e) {
  const auto across = mesh.twin(e);
  return !across || e < *across;
}

template <class Visit>
void for_each_constrained_edge(const Mesh& mesh, Visit visit) {
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      if (mesh.is_constrained(e) && is_first_side(mesh, e)) visit(e);
    }
  }
}

double length(const Mesh& mesh, HalfEdge e) {
  return std::sqrt(squared_distance(mesh.point(mesh.origin(e)), mesh.point(mesh.destination(e))));
}

double area(const Mesh& mesh, TriangleId t) {
  const auto [a, b, c] = mesh.corners(t);
  return signed_area(a, b, c);
}

template <class T>
void keep_distinct(std::vector<T>& values) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

// The curves that an edge is a piece of, each once, ascending.
void find_curves(const Mesh& mesh, HalfEdge e, std::vector<CurveId>& curves) {
  curves.clear();
  for (const SegmentId s : mesh.segments_of(e)) {
    const auto curve = mesh.segments()[s.index()].curve;
    if (curve) curves.push_back(*curve);
  }
  if (curves.size() > 1) keep_distinct(curves);
}

std::vector<double> values_of(const std::vector<CompensatedSum>& sums) {
  std::vector<double> values;
  values.reserve(sums.size());
  for (const CompensatedSum& sum : sums) values.push_back(sum.value());
  return values;
}

std::vector<double> areas_of_surfaces(const Mesh& mesh) {
  std::vector<CompensatedSum> areas(mesh.entities().surfaces.size());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const std::size_t region = mesh.region(TriangleId(t)).index();
    if (region < areas.size()) areas[region].add(area(mesh, TriangleId(t)));
  }
  return values_of(areas);
}

}  // namespace

Quality measure(const Mesh& mesh) { return Measurer(mesh).measure(); }

EntityMeasures measure_entities(const Mesh& mesh) {
  std::vector<CompensatedSum> lengths(mesh.entities().curves.size());
  std::vector<CurveId> curves;
  for_each_constrained_edge(mesh, [&](HalfEdge e) {
    find_curves(mesh, e, curves);
    for (const CurveId curve : curves) lengths[curve.index()].add(length(mesh, e));
  });
  return {values_of(lengths), areas_of_surfaces(mesh)};
}

std::vector<double> measure_groups(const Mesh& mesh) {
  const Entities& entities = mesh.entities();
  std::vector<CompensatedSum> measures(entities.groups.size());
  for (const PointEntity& point : entities.points) {
    for (const GroupId group : point.groups) measures[group.index()].add(1);
  }
  if (measures.empty()) return {};
  std::vector<CurveId> curves;
  std::vector<GroupId> groups;
  for_each_constrained_edge(mesh, [&](HalfEdge e) {
    find_curves(mesh, e, curves);
    groups.clear();
    for (const CurveId curve : curves) {
      const auto& of_curve = entities[curve].groups;
      groups.insert(groups.end(), of_curve.begin(), of_curve.end());
    }
    if (groups.size() > 1) keep_distinct(groups);
    for (const GroupId group : groups) measures[group.index()].add(length(mesh, e));
  });
  const std::vector<double> areas = areas_of_surfaces(mesh);
  for (std::size_t s = 0; s < areas.size(); ++s) {
    for (const GroupId group : entities.surfaces[s].groups) measures[group.index()].add(areas[s]);
  }
  return values_of(measures);
}

bool is_below(const Mesh& mesh, TriangleId t, double min_angle_deg) {
  const auto [a, b, c] = mesh.corners(t);
  return std::ranges::min(angles_deg(a, b, c)) < min_angle_deg - 1e-9;
}

double total_area(const Mesh& mesh) {
  CompensatedSum sum;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) sum.add(area(mesh, TriangleId(t)));
  return sum.value();
}

}  // namespace lepp
