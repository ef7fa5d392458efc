#include "lepp/voronoi/box_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

#include "lepp/geometry/text.hpp"
#include "lepp/voronoi/names.hpp"

namespace lepp {

namespace {

constexpr double area_tolerance = 1e-12;  // of the area that is compared

// How far a rounded coordinate of this size may be from the place it stands for.
double rounding_of(double coordinate) {
  return 4 * std::numeric_limits<double>::epsilon() * coordinate;
}

double largest_coordinate(std::span<const Point> points) {
  double largest = 0;
  for (const Point p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return largest;
}

std::string name_of(const Mesh& mesh, const VoronoiBox& box) {
  return name_of(mesh, box.vertex) + " in " + name_of(mesh, box.region);
}

std::size_t regions_of(const Mesh& mesh) {
  std::size_t regions = 0;
  for (const Triangle& t : mesh.triangles()) regions = std::max(regions, t.region().index() + 1);
  return regions;
}

bool has_its_pieces(const VoronoiBoxes& boxes, const VoronoiBox& box) {
  const std::size_t pieces = boxes.piece_triangle.size();
  return boxes.piece_begin.size() == pieces + 1 &&
         boxes.piece_begin.back() <= boxes.corners.size() && box.first_piece <= pieces &&
         box.pieces <= pieces - box.first_piece;
}

double area_of_pieces(const VoronoiBoxes& boxes, const VoronoiBox& box) {
  double twice = 0;
  for (std::uint32_t i = box.first_piece; i < box.first_piece + box.pieces; ++i) {
    const auto corners = boxes.piece(i);
    for (std::size_t j = 2; j < corners.size(); ++j) {
      twice += cross(corners[j - 1] - corners[0], corners[j] - corners[0]);
    }
  }
  return 0.5 * twice;
}

// How far from the area of the pieces their rounded corners may take it.
double rounding_of_pieces(const VoronoiBoxes& boxes, const VoronoiBox& box) {
  double rounding = 0;
  for (std::uint32_t i = box.first_piece; i < box.first_piece + box.pieces; ++i) {
    const auto corners = boxes.piece(i);
    const double rounding_of_corners = rounding_of(largest_coordinate(corners));
    for (std::size_t j = 0; j < corners.size(); ++j) {
      const Point p = corners[j], q = corners[(j + 1) % corners.size()];
      rounding += rounding_of_corners * std::sqrt(squared_distance(p, q));
    }
  }
  return rounding;
}

double larger_size(Point d) { return std::max(std::abs(d.x), std::abs(d.y)); }

// Up to 1e-12 of its size and rounding. Lengths are measured from below, without roots.
bool lies_in(std::span<const Point> corners, const std::array<Point, 3>& triangle) {
  const auto [a, b, c] = triangle;
  const std::array<Point, 3> sides{b - a, c - b, a - c};
  const double size = std::max(larger_size(sides[0]), larger_size(sides[2]));
  const double slack = 1e-12 * size + rounding_of(largest_coordinate(triangle));
  bool all_inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const double most = slack * larger_size(sides[i]);  // of the distance, times the length
    for (const Point p : corners) all_inside &= -cross(sides[i], p - triangle[i]) <= most;
  }
  return all_inside;
}

}  // namespace

BoxChecks::BoxChecks(const Mesh& mesh) : mesh_(mesh), covered_(regions_of(mesh)) {
  found_.reserve(mesh.vertex_count());
}

void BoxChecks::add(const VoronoiBoxes& some) {
  for (const VoronoiBox& box : some.boxes) {
    found_.emplace_back(box.vertex, box.region);
    if (box.region.index() < covered_.size())
      covered_[box.region.index()].add(box.area);  // else V3
    if (has_its_pieces(some, box)) {
      check_area(some, box);
      check_pieces(some, box);
    } else {
      wrong_pieces_.push_back({"V3", name_of(mesh_, box) + ": its box has lost its pieces"});
    }
  }
}

// The area of a box is that of its pieces, as far as their rounded corners can tell.
void BoxChecks::check_area(const VoronoiBoxes& boxes, const VoronoiBox& box) {
  const double area = area_of_pieces(boxes, box);
  const double error = std::abs(area - box.area);
  if (error <= area_tolerance * area) return;  // spares nearly all boxes the rest
  if (error <= area_tolerance * area + rounding_of_pieces(boxes, box)) return;
  wrong_areas_.push_back({"V2", name_of(mesh_, box) + ": its box has the area " +
                                    to_text(box.area) + ", its pieces " + to_text(area)});
}

void BoxChecks::check_pieces(const VoronoiBoxes& boxes, const VoronoiBox& box) {
  for (std::uint32_t i = box.first_piece; i < box.first_piece + box.pieces; ++i) {
    const TriangleId t = boxes.piece_triangle[i];
    if (t.index() < mesh_.triangle_count() && mesh_.region(t) == box.region &&
        lies_in(boxes.piece(i), mesh_.corners(t))) {
      continue;
    }
    wrong_pieces_.push_back(
        {"V3", name_of(mesh_, box) + ": a piece of its box lies in no triangle there"});
  }
}

void BoxChecks::report(Certificate& result) const {
  report_region_areas(result);
  const auto append = [&](const std::vector<BoxViolation>& more) {
    result.violations.insert(result.violations.end(), more.begin(), more.end());
  };
  append(wrong_areas_);
  report_one_box_per_region(result);
  append(wrong_pieces_);
}

void BoxChecks::report_region_areas(Certificate& result) const {  // V2
  std::vector<CompensatedSum> wanted(covered_.size());
  for (const Triangle& t : mesh_.triangles()) {
    const Point a = mesh_.point(t.vertices[0]);
    wanted[t.region().index()].add(
        0.5 * cross(mesh_.point(t.vertices[1]) - a, mesh_.point(t.vertices[2]) - a));
  }
  for (std::size_t r = 0; r < wanted.size(); ++r) {
    const double area = wanted[r].value(), sum = covered_[r].value();
    if (area == 0) continue;  // a region without triangles
    const double error = std::abs(sum - area) / area;
    const double defect = std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
    result.largest_area_defect = std::max(result.largest_area_defect, defect);
    if (defect <= area_tolerance) continue;
    result.violations.push_back({"V2", name_of(mesh_, SurfaceId(r)) + ": its boxes cover " +
                                           to_text(sum) + " of its area " + to_text(area)});
  }
}

// Sorted. Nearly all vertices have one region around them.
std::vector<BoxChecks::VertexAndRegion> BoxChecks::boxes_wanted() const {
  std::vector<VertexAndRegion> wanted(mesh_.vertex_count());
  std::vector<VertexAndRegion> more;
  for (const Triangle& t : mesh_.triangles()) {
    for (const VertexId v : t.vertices) wanted[v.index()] = {v, t.region()};
  }
  for (const Triangle& t : mesh_.triangles()) {
    for (const VertexId v : t.vertices) {
      if (wanted[v.index()].second != t.region()) more.emplace_back(v, t.region());
    }
  }
  if (more.empty()) return wanted;
  wanted.insert(wanted.end(), more.begin(), more.end());
  std::ranges::sort(wanted);
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  return wanted;
}

void BoxChecks::report_one_box_per_region(Certificate& result) const {  // V3
  const std::vector<VertexAndRegion> wanted = boxes_wanted();
  std::vector<VertexAndRegion> found = found_;
  if (!std::ranges::is_sorted(found)) std::ranges::sort(found);
  const auto report = [&](const std::vector<VertexAndRegion>& places, const char* problem) {
    for (const auto& [v, region] : places) {
      result.violations.push_back(
          {"V3", name_of(mesh_, v) + " in " + name_of(mesh_, region) + problem});
    }
  };
  std::vector<VertexAndRegion> missing, surplus;
  std::ranges::set_difference(wanted, found, std::back_inserter(missing));
  std::ranges::set_difference(found, wanted, std::back_inserter(surplus));
  report(missing, ": has no box");
  report(surplus, ": has a box too many");
}

}  // namespace lepp
