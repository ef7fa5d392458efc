#include "lepp/triangulation/quality.hpp"

#include <algorithm>
#include <cmath>

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

// One pass over triangles and edges.
class Measurer {
 public:
  explicit Measurer(const Mesh& mesh) : mesh_(mesh), smallest_(180) {}

  Quality measure();

 private:
  void measure_triangle(TriangleId t);
  void measure_obtuse(HalfEdge e, bool exact, bool tolerant);
  void measure_delaunay(HalfEdge e, HalfEdge across, double angle_deg);

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
  const auto p = mesh_.corners(t);
  const auto angles = angles_deg(p[0], p[1], p[2]);
  const auto [smallest, largest] = std::ranges::minmax(angles);
  smallest_ = std::min(smallest_, smallest);
  largest_ = std::max(largest_, largest);
  smallest_sum_.add(smallest);
  largest_sum_.add(largest);
  bool is_obtuse_triangle = false;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HalfEdge e{t, i};
    const bool exact = is_obtuse(p[next_corner(i)], p[i], p[previous_corner(i)]);
    is_obtuse_triangle |= exact;
    measure_obtuse(e, exact, angles[i] > 90 + forgiven_deg);
    const auto across = mesh_.twin(e);
    if (across && e < *across) measure_delaunay(e, *across, angles[i]);
  }
  count(quality_.obtuse_triangles, is_obtuse_triangle, largest > 90 + forgiven_deg);
}

void Measurer::measure_obtuse(HalfEdge e, bool exact, bool tolerant) {
  if (mesh_.is_constrained(e)) count(quality_.obtuse_constrained, exact, tolerant);
  if (mesh_.is_boundary(e)) count(quality_.obtuse_boundary, exact, tolerant);
}

void Measurer::measure_delaunay(HalfEdge e, HalfEdge across, double angle_deg) {
  const auto [a, b, c] = mesh_.corners(e.triangle);
  const auto q = mesh_.corners(across.triangle);
  const double across_deg = angles_deg(q[0], q[1], q[2])[across.edge];
  auto& counter =
      mesh_.is_constrained(e) ? quality_.non_delaunay_constrained : quality_.non_delaunay_edges;
  count(counter, incircle(a, b, c, mesh_.point(mesh_.apex(across))) > 0,
        angle_deg + across_deg > 180 + forgiven_deg);
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
  const Point d = mesh.point(mesh.destination(e)) - mesh.point(mesh.origin(e));
  return std::hypot(d.x, d.y);
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
  keep_distinct(curves);
}

std::vector<double> values_of(const std::vector<CompensatedSum>& sums) {
  std::vector<double> values;
  values.reserve(sums.size());
  for (const CompensatedSum& sum : sums) values.push_back(sum.value());
  return values;
}

}  // namespace

Quality measure(const Mesh& mesh) { return Measurer(mesh).measure(); }

EntityMeasures measure_entities(const Mesh& mesh) {
  std::vector<CompensatedSum> lengths(mesh.entities().curves.size());
  std::vector<CompensatedSum> areas(mesh.entities().surfaces.size());
  std::vector<CurveId> curves;
  for_each_constrained_edge(mesh, [&](HalfEdge e) {
    find_curves(mesh, e, curves);
    for (const CurveId curve : curves) lengths[curve.index()].add(length(mesh, e));
  });
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const std::size_t region = mesh.region(TriangleId(t)).index();
    if (region < areas.size()) areas[region].add(area(mesh, TriangleId(t)));
  }
  return {values_of(lengths), values_of(areas)};
}

std::vector<double> measure_groups(const Mesh& mesh) {
  const Entities& entities = mesh.entities();
  std::vector<CompensatedSum> measures(entities.groups.size());
  for (const PointEntity& point : entities.points) {
    for (const GroupId group : point.groups) measures[group.index()].add(1);
  }
  std::vector<CurveId> curves;
  std::vector<GroupId> groups;
  for_each_constrained_edge(mesh, [&](HalfEdge e) {
    find_curves(mesh, e, curves);
    groups.clear();
    for (const CurveId curve : curves) {
      const auto& of_curve = entities[curve].groups;
      groups.insert(groups.end(), of_curve.begin(), of_curve.end());
    }
    keep_distinct(groups);
    for (const GroupId group : groups) measures[group.index()].add(length(mesh, e));
  });
  const std::vector<double> areas = measure_entities(mesh).surface_areas;
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
