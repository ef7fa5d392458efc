#include "lepp/voronoi/admissible.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

#include "lepp/geometry/compensated_sum.hpp"
#include "lepp/geometry/text.hpp"
#include "lepp/geometry/triangle_measures.hpp"

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

std::string name_of(const Mesh& mesh, SurfaceId region) {
  const auto& surfaces = mesh.entities().surfaces;
  if (region.index() >= surfaces.size()) return "region " + std::to_string(region.value);
  return "surface " + std::to_string(surfaces[region.index()].tag);
}

std::string name_of(const Mesh& mesh, VertexId v) {
  if (v.index() >= mesh.vertex_count()) return "no vertex " + std::to_string(v.value);
  return "vertex " + to_text(mesh.point(v));
}

std::string name_of(const Mesh& mesh, const VoronoiBox& box) {
  return name_of(mesh, box.vertex) + " in " + name_of(mesh, box.region);
}

void check_edge_factors(const Mesh& mesh, Certificate& result) {  // V1
  for (const EdgeFactor& f : edge_factors(mesh)) {
    if (f.sign >= 0) continue;
    result.offending.push_back(f);
    result.violations.push_back(
        {"V1", "edge " + to_text(mesh.point(f.k)) + " - " + to_text(mesh.point(f.l)) + " in " +
                   name_of(mesh, f.region) + ": factor " + to_text(f.factor) +
                   ", opposite angles " + to_text(f.angle_deg) + " degrees"});
  }
}

void check_region_areas(const Mesh& mesh, const VoronoiBoxes& boxes, Certificate& result) {  // V2
  std::size_t regions = 0;
  for (const Triangle& t : mesh.triangles()) regions = std::max(regions, t.region().index() + 1);
  std::vector<CompensatedSum> wanted(regions), covered(regions);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    wanted[mesh.region(TriangleId(t)).index()].add(signed_area(a, b, c));
  }
  for (const VoronoiBox& box : boxes.boxes) {
    if (box.region.index() < regions) covered[box.region.index()].add(box.area);  // else V3
  }
  for (std::size_t r = 0; r < regions; ++r) {
    const double area = wanted[r].value(), sum = covered[r].value();
    if (area == 0) continue;  // a region without triangles
    const double error = std::abs(sum - area) / area;
    const double defect = std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
    result.largest_area_defect = std::max(result.largest_area_defect, defect);
    if (defect <= area_tolerance) continue;
    result.violations.push_back({"V2", name_of(mesh, SurfaceId(r)) + ": its boxes cover " +
                                           to_text(sum) + " of its area " + to_text(area)});
  }
}

bool has_its_pieces(const VoronoiBoxes& boxes, const VoronoiBox& box) {
  const std::size_t pieces = boxes.piece_triangle.size();
  return boxes.piece_begin.size() == pieces + 1 &&
         boxes.piece_begin.back() <= boxes.corners.size() && box.first_piece <= pieces &&
         box.pieces <= pieces - box.first_piece;
}

// The area of a box is that of its pieces, as far as their rounded corners can tell.
void check_box_area(const Mesh& mesh, const VoronoiBoxes& boxes, const VoronoiBox& box,
                    Certificate& result) {  // V2
  double area = 0, rounding = 0;
  for (std::uint32_t i = box.first_piece; i < box.first_piece + box.pieces; ++i) {
    const auto corners = boxes.piece(i);
    const double rounding_of_corners = rounding_of(largest_coordinate(corners));
    for (std::size_t j = 0; j < corners.size(); ++j) {
      const Point p = corners[j], q = corners[(j + 1) % corners.size()];
      area += signed_area(corners[0], p, q);
      rounding += rounding_of_corners * std::sqrt(squared_distance(p, q));
    }
  }
  if (std::abs(area - box.area) <= area_tolerance * area + rounding) return;
  result.violations.push_back({"V2", name_of(mesh, box) + ": its box has the area " +
                                         to_text(box.area) + ", its pieces " + to_text(area)});
}

bool lies_in(std::span<const Point> corners, const std::array<Point, 3>& triangle) {
  const double size = std::sqrt(std::max(squared_distance(triangle[0], triangle[1]),
                                         squared_distance(triangle[0], triangle[2])));
  const double slack = 1e-12 * size + rounding_of(largest_coordinate(triangle));
  return std::ranges::all_of(corners, [&](Point p) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Point a = triangle[i], b = triangle[(i + 1) % 3];
      const double beyond = -cross(b - a, p - a) / std::sqrt(squared_distance(a, b));
      if (!(beyond <= slack)) return false;
    }
    return true;
  });
}

void check_pieces(const Mesh& mesh, const VoronoiBoxes& boxes, const VoronoiBox& box,
                  Certificate& result) {  // V3
  for (std::uint32_t i = box.first_piece; i < box.first_piece + box.pieces; ++i) {
    const TriangleId t = boxes.piece_triangle[i];
    if (t.index() < mesh.triangle_count() && mesh.region(t) == box.region &&
        lies_in(boxes.piece(i), mesh.corners(t))) {
      continue;
    }
    result.violations.push_back(
        {"V3", name_of(mesh, box) + ": a piece of its box lies in no triangle there"});
  }
}

using VertexAndRegion = std::pair<VertexId, SurfaceId>;

std::vector<VertexAndRegion> boxes_wanted(const Mesh& mesh) {
  std::vector<VertexAndRegion> wanted;
  wanted.reserve(3 * mesh.triangle_count());
  for (const Triangle& t : mesh.triangles()) {
    for (const VertexId v : t.vertices) wanted.emplace_back(v, t.region());
  }
  std::ranges::sort(wanted);
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  return wanted;
}

void check_one_box_per_region(const Mesh& mesh, const VoronoiBoxes& boxes,
                              Certificate& result) {  // V3
  const std::vector<VertexAndRegion> wanted = boxes_wanted(mesh);
  std::vector<VertexAndRegion> found;
  found.reserve(boxes.boxes.size());
  for (const VoronoiBox& box : boxes.boxes) found.emplace_back(box.vertex, box.region);
  std::ranges::sort(found);
  const auto report = [&](const std::vector<VertexAndRegion>& places, const char* problem) {
    for (const auto& [v, region] : places) {
      result.violations.push_back(
          {"V3", name_of(mesh, v) + " in " + name_of(mesh, region) + problem});
    }
  };
  std::vector<VertexAndRegion> missing, surplus;
  std::ranges::set_difference(wanted, found, std::back_inserter(missing));
  std::ranges::set_difference(found, wanted, std::back_inserter(surplus));
  report(missing, ": has no box");
  report(surplus, ": has a box too many");
}

}  // namespace

Certificate certify(const Mesh& mesh, const VoronoiBoxes& boxes) {
  Certificate result;
  check_edge_factors(mesh, result);
  check_region_areas(mesh, boxes, result);
  for (const VoronoiBox& box : boxes.boxes) {
    if (has_its_pieces(boxes, box)) check_box_area(mesh, boxes, box, result);
  }
  check_one_box_per_region(mesh, boxes, result);
  for (const VoronoiBox& box : boxes.boxes) {
    if (has_its_pieces(boxes, box)) check_pieces(mesh, boxes, box, result);
    else result.violations.push_back({"V3", name_of(mesh, box) + ": its box has lost its pieces"});
  }
  result.admissible = result.violations.empty();
  return result;
}

Certificate certify(const Mesh& mesh) {
  Certificate result;
  check_edge_factors(mesh, result);
  return result.violations.empty() ? certify(mesh, voronoi_boxes(mesh)) : result;
}

std::string Certificate::summary() const {
  if (admissible) return "admissible";
  constexpr std::size_t shown = 3;
  std::string text = "not admissible";
  for (std::size_t i = 0; i < std::min(shown, violations.size()); ++i) {
    text += (i == 0 ? ": " : "; ") + violations[i].rule + " " + violations[i].where;
  }
  if (violations.size() > shown) {
    text += "; and " + std::to_string(violations.size() - shown) + " more";
  }
  return text;
}

}  // namespace lepp
