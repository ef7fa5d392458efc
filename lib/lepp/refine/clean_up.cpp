#include "lepp/refine/clean_up.hpp"

#include <algorithm>

#include "lepp/geometry/predicates.hpp"
#include "lepp/triangulation/locate.hpp"
#include "lepp/triangulation/remove_vertex.hpp"

namespace lepp {

namespace {

constexpr int most_rounds = 12, few_rounds = 4;
// A round that removes less than this part of the vertices is the last.
constexpr std::size_t next_to_nothing = 1000;

// The corner of `v` in one of its triangles.
struct Corner {
  TriangleId triangle;
  std::uint32_t corner;
};

Corner corner_of(const Mesh& mesh, VertexId v) {
  const HalfEdge e = mesh.leaving(v);
  return {e.triangle, next_corner(e.edge)};
}

}  // namespace

CleanUp::CleanUp(Mesh& mesh, const RefineOptions& options, double floor)
    : mesh_(mesh),
      options_(options),
      angle_(options.min_angle_deg, options.max_angle_deg),
      size_(mesh, options),
      merges_(options.effort == Effort::best || options.max_angle_deg < 180),
      good_star_(mesh, options, floor),
      times_(mesh) {}

void CleanUp::run() {
  const int rounds = options_.effort == Effort::best ? most_rounds : merges_ ? few_rounds : 1;
  for (int round = 1;; ++round) {
    const std::size_t removed = remove_needless();
    if (round == rounds || removed * next_to_nothing < mesh_.vertex_count()) return;
    relax();
  }
}

// How many fewer there are.
std::size_t CleanUp::remove_needless() {
  const std::size_t before = mesh_.vertex_count();
  for (std::size_t i = before; i-- > 0;) {  // the last vertex takes the place of a removed one
    const VertexId v(i);
    if (i >= mesh_.vertex_count() || mesh_.is_input(v) || !times_.is_due(v)) continue;
    if (!may_go_on()) break;
    if (can_do_without(v)) remove(v);
    else if (!merges_ || !merge_with_neighbour(v)) times_.tried(v);
  }
  return before - mesh_.vertex_count();
}

void CleanUp::relax() {
  for (std::size_t i = 0; i < mesh_.vertex_count() && may_go_on(); ++i) {
    const auto [t, corner] = corner_of(mesh_, VertexId(i));
    changed_.clear();
    if (!good_star_.move_corner(t, corner, changed_)) continue;
    for_each_in_fan(mesh_, VertexId(i),
                    [&](TriangleId around, std::uint32_t) { changed_.push_back(around); });
    times_.changed(changed_);
  }
}

bool CleanUp::can_do_without(VertexId v) {
  const auto [t, corner] = corner_of(mesh_, v);
  if (mesh_.origin_of(v).kind == VertexOrigin::Kind::interior) {
    return find_star(mesh_, t, corner, star_) && is_needless_inside(star_);
  }
  return is_needless_on_segment(v);
}

// Of all ways to fill the star the Delaunay one has the largest smallest angle, so one good way is
// enough. Fans are all there are up to five corners.
bool CleanUp::is_needless_inside(const Star& star) {
  const SurfaceId region = mesh_.region(star.link.front().edge.triangle);
  polygon_.clear();
  for (const auto& side : star.link) polygon_.push_back(side.from);
  for (std::size_t from = 0; from < star.size(); ++from) {
    if (is_good_fan(polygon_, from, region)) return true;
  }
  return false;
}

bool CleanUp::is_good_fan(std::span<const Point> polygon, std::size_t from,
                          SurfaceId region) const {
  const std::size_t n = polygon.size();
  const auto at = [&](std::size_t i) { return polygon[from + i < n ? from + i : from + i - n]; };
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Point a = at(0), b = at(i), c = at(i + 1);
    if (angle_.is_bad(a, b, c) || orient2d(a, b, c) <= 0) return false;
    if (size_.is_too_large(a, b, c, region)) return false;
  }
  return true;
}

// The two sides of v's segment, each a polygon from one neighbour on the segment to the other.
bool CleanUp::is_needless_on_segment(VertexId v) {
  struct Side {
    SurfaceId region;
    std::vector<Point> points;
  };
  std::vector<Side> sides;
  std::vector<Point> first;  // what came before the first constrained edge
  for_each_in_fan(mesh_, v, [&](TriangleId t, std::uint32_t corner) {
    const HalfEdge spoke{t, previous_corner(corner)}, outer{t, corner};
    if (mesh_.is_constrained(spoke)) {
      sides.push_back({mesh_.region(t), {mesh_.point(mesh_.origin(outer))}});
    }
    auto& points = sides.empty() ? first : sides.back().points;
    points.push_back(mesh_.point(mesh_.destination(outer)));
  });
  if (sides.empty()) return false;
  auto& last = sides.back().points;
  last.insert(last.end(), first.begin(), first.end());
  return std::ranges::all_of(sides,
                             [&](const Side& side) {
                               const auto& points = side.points;
                               if (points.size() < 3) return false;
                               for (std::size_t i = 1; i + 1 < points.size(); ++i) {
                                 if (is_obtuse(points.front(), points[i], points.back()))
                                   return false;
                               }
                               return is_good_fan(points, 0, side.region) ||
                                      is_good_fan(points, points.size() - 1, side.region);
                             }) &&
         is_removable(removability(mesh_, v));
}

bool CleanUp::merge_with_neighbour(VertexId v) {
  const auto [t, corner] = corner_of(mesh_, v);
  if (!good_star_.start_to_merge(t, corner)) return false;
  for (std::size_t i = 0; i < good_star_.degree(); ++i) {
    const VertexId w = good_star_.neighbour(i);
    if (times_.was_tried_beside(v, w)) continue;
    if (const auto place = good_star_.place_for_both(i)) {
      replace_both(v, w, *place);
      return true;
    }
  }
  return false;
}

// The triangles around p are Delaunay or will be flipped, which makes them no worse.
void CleanUp::replace_both(VertexId v, VertexId w, Point p) {
  remove(std::max(v, w));
  const TriangleId beside = remove(std::min(v, w));
  const auto place = locate(mesh_, p, beside);
  if (place && cavity_.find(mesh_, place->triangle, p)) {
    cavity_.fill(mesh_, p, {VertexOrigin::Kind::interior, 0});
    times_.added();
    times_.changed(cavity_.triangles());
  }
}

// Returns a triangle where it was.
TriangleId CleanUp::remove(VertexId v) {
  const auto removal = remove_vertex(mesh_, v);
  times_.removed(v);
  times_.changed(removal->changed);
  return removal->changed.front();
}

}  // namespace lepp
