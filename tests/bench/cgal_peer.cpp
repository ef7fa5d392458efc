#include "bench/cgal_peer.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <utility>
#include <vector>

namespace lepp::test {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
enum class Mark { unknown, outside };
using Face =
    CGAL::Triangulation_face_base_with_info_2<Mark, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure =
    CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>, Face>;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, Structure, CGAL::No_constraint_intersection_requiring_constructions_tag>;

std::vector<Kernel::Point_2> points_of(const Pslg& pslg) {
  std::vector<Kernel::Point_2> points;
  points.reserve(pslg.points.size());
  for (const Point p : pslg.points) points.emplace_back(p.x, p.y);
  return points;
}

// Marks what is reached from `start` without crossing a constraint.
void mark_outside(Constrained& cdt, Constrained::Face_handle start) {
  std::vector<Constrained::Face_handle> open{start};
  start->info() = Mark::outside;
  while (!open.empty()) {
    const auto face = open.back();
    open.pop_back();
    for (int i = 0; i < 3; ++i) {
      const auto next = face->neighbor(i);
      if (next->info() == Mark::outside || cdt.is_constrained({face, i})) continue;
      next->info() = Mark::outside;
      open.push_back(next);
    }
  }
}

}  // namespace

std::size_t cgal_delaunay(const Pslg& pslg) {
  const auto points = points_of(pslg);
  CGAL::Delaunay_triangulation_2<Kernel> triangulation(points.begin(), points.end());
  return triangulation.number_of_faces();
}

std::size_t cgal_constrained_delaunay(const Pslg& pslg) {
  const auto points = points_of(pslg);
  std::vector<std::pair<std::size_t, std::size_t>> segments;
  segments.reserve(pslg.segments.size());
  for (const Segment& s : pslg.segments) segments.emplace_back(s.a.index(), s.b.index());
  Constrained cdt;
  // This inserts all points, sorted in space, and then the constraints.
  cdt.insert_constraints(points.begin(), points.end(), segments.begin(), segments.end());
  if (!pslg.segments.empty()) mark_outside(cdt, cdt.infinite_face());
  for (const Point hole : pslg.holes) {
    const auto face = cdt.locate({hole.x, hole.y});
    if (face->info() != Mark::outside) mark_outside(cdt, face);
  }
  std::size_t inside = 0;
  for (auto face = cdt.finite_faces_begin(); face != cdt.finite_faces_end(); ++face) {
    inside += face->info() != Mark::outside;
  }
  return inside;
}

}  // namespace lepp::test
