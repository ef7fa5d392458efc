#include "lepp/voronoi/voronoi_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "lepp/geometry/compensated_sum.hpp"
#include "lepp/voronoi/corners_by_box.hpp"
#include "lepp/voronoi/cut_polygon.hpp"

namespace lepp {

namespace {

// A part of a triangle smaller than this, relative to its longest side squared, is rounding.
constexpr double rounding_area = 1e-14;

double longest_squared_side(const std::array<Point, 3>& p) {
  return std::max(
      {squared_distance(p[0], p[1]), squared_distance(p[1], p[2]), squared_distance(p[2], p[0])});
}

double length_of(Point d) { return std::hypot(d.x, d.y); }

// A wall ends boxes: beyond it lies another region, no mesh, or what a constraint keeps apart.
bool is_wall(const Mesh& mesh, HalfEdge e) {
  return mesh.is_constrained(e) || mesh.separates_regions(e);
}

// Cuts the boxes one by one, and each box sector by sector: the sector of a triangle at k is what
// k sees through that corner.
class BoxCutter {
 public:
  explicit BoxCutter(const Mesh& mesh) : mesh_(mesh), corners_(mesh) {
    const std::size_t triangles = mesh.triangle_count();
    result_.boxes.reserve(corners_.box_count());
    result_.faces.reserve(triangles + mesh.vertex_count() + corners_.box_count());
    result_.corners.reserve(13 * triangles);
    result_.piece_begin.reserve(3 * triangles + 1);
    result_.piece_triangle.reserve(3 * triangles);
    result_.piece_begin.push_back(0);
  }

  VoronoiBoxes cut();

 private:
  void cut_sector(TriangleCorner corner);
  void find_neighbours(TriangleCorner corner);
  void cut_part_of(TriangleId t);
  void follow_part(TriangleId t);
  void keep_part_of(TriangleId t);
  void add_faces();

  Point seen_from_k(VertexId v) const { return mesh_.point(v) - x_k_; }

  const Mesh& mesh_;
  CornersByBox corners_;
  VoronoiBoxes result_;

  // The box that is being cut.
  VertexId k_;
  Point x_k_;  // the origin of all that follows: differences first, for meshes far from zero
  SurfaceId region_;
  CompensatedSum area_;
  std::vector<VoronoiFace> sides_;  // of all boxes of k; several may make one face

  // The sector that is being cut.
  std::vector<VertexId> neighbours_;   // those of k that may bound it; the triangle's own two first
  std::vector<TriangleId> triangles_;  // those it may reach, in the order in which it enters them
  CutPolygon part_;                    // its part in one of them
};

VoronoiBoxes BoxCutter::cut() {
  for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
    k_ = VertexId(v);
    x_k_ = mesh_.point(k_);
    sides_.clear();
    for (auto box = corners_.first_box(v); box < corners_.first_box(v + 1); ++box) {
      region_ = corners_.region(box);
      area_ = {};
      const auto first_piece = static_cast<std::uint32_t>(result_.piece_triangle.size());
      for (const TriangleCorner corner : corners_.corners(box)) cut_sector(corner);
      const auto pieces = static_cast<std::uint32_t>(result_.piece_triangle.size()) - first_piece;
      result_.boxes.push_back({k_, region_, area_.value(), first_piece, pieces});
    }
    add_faces();
  }
  return std::move(result_);
}

// The sector starts in its own triangle. Where its part there ends at an edge and not at a
// bisector, it goes on beyond the edge, unless that is a wall.
void BoxCutter::cut_sector(TriangleCorner corner) {
  find_neighbours(corner);
  triangles_.assign(1, corner.triangle);
  for (std::size_t i = 0; i < triangles_.size(); ++i) {  // ends: each triangle enters once
    cut_part_of(triangles_[i]);
  }
}

// A neighbour at 90 degrees or more from each ray of the sector is never nearer than k. So we turn
// both ways as far as that, or to a wall: what lies beyond a wall, near as it may be, does not
// bound the box on this side.
void BoxCutter::find_neighbours(TriangleCorner corner) {
  const HalfEdge leaving{corner.triangle, previous_corner(corner.corner)};
  const HalfEdge arriving{corner.triangle, next_corner(corner.corner)};
  const VertexId a = mesh_.destination(leaving), b = mesh_.origin(arriving);
  neighbours_.assign({a, b});
  for (const VertexId l : {a, b}) sides_.push_back({k_, l, region_, 0, 0});
  for (HalfEdge e = leaving; !is_wall(mesh_, e);) {  // clockwise from a
    e = next_edge(*mesh_.twin(e));
    const VertexId l = mesh_.destination(e);
    if (dot(seen_from_k(a), seen_from_k(l)) <= 0) break;
    neighbours_.push_back(l);
  }
  for (HalfEdge e = arriving; !is_wall(mesh_, e);) {  // counter-clockwise from b
    e = previous_edge(*mesh_.twin(e));
    const VertexId l = mesh_.origin(e);
    if (dot(seen_from_k(b), seen_from_k(l)) <= 0) break;
    neighbours_.push_back(l);
  }
}

void BoxCutter::cut_part_of(TriangleId t) {
  const auto& v = mesh_.vertices(t);
  part_.start_with(seen_from_k(v[0]), seen_from_k(v[1]), seen_from_k(v[2]));
  if (t != triangles_.front()) {  // stay between the rays of the sector
    const Side ray{Side::Kind::ray, 0};
    if (!part_.keep(left_of_ray(seen_from_k(neighbours_[0])), ray)) return;
    if (!part_.keep(right_of_ray(seen_from_k(neighbours_[1])), ray)) return;
  }
  for (std::uint32_t i = 0; i < neighbours_.size(); ++i) {
    const HalfPlane nearer = nearer_to_origin_than(seen_from_k(neighbours_[i]));
    if (!part_.keep(nearer, {Side::Kind::bisector, i})) return;
  }
  follow_part(t);
  keep_part_of(t);
}

void BoxCutter::follow_part(TriangleId t) {
  for (const CutPolygon::Corner& corner : part_.corners()) {
    if (corner.side.kind != Side::Kind::edge) continue;
    const HalfEdge e{t, corner.side.index};
    if (is_wall(mesh_, e)) continue;
    if (mesh_.origin(e) == k_ || mesh_.destination(e) == k_) continue;  // another sector
    const TriangleId next = mesh_.twin(e)->triangle;
    if (std::ranges::find(triangles_, next) == triangles_.end()) triangles_.push_back(next);
  }
}

void BoxCutter::keep_part_of(TriangleId t) {
  const double area = part_.area();
  const bool is_own = t == triangles_.front();  // what is next to k is k's, however thin
  if (!is_own && area <= rounding_area * longest_squared_side(mesh_.corners(t))) return;
  area_.add(area);
  for (std::size_t i = 0; i < part_.corners().size(); ++i) {
    const CutPolygon::Corner& corner = part_.corners()[i];
    result_.corners.push_back(x_k_ + corner.at);
    if (corner.side.kind != Side::Kind::bisector) continue;
    const double length = length_of(part_.after(i).at - corner.at);
    sides_.push_back({k_, neighbours_[corner.side.index], region_, length, 0});
  }
  result_.piece_begin.push_back(static_cast<std::uint32_t>(result_.corners.size()));
  result_.piece_triangle.push_back(t);
}

// One face per edge and region, though cocircular vertices leave it no length; measured once, from
// the vertex that comes first.
void BoxCutter::add_faces() {
  std::erase_if(sides_, [](const VoronoiFace& side) { return side.l < side.k; });
  const auto key = [](const VoronoiFace& side) { return std::tuple(side.l, side.region); };
  std::ranges::stable_sort(sides_, {}, key);
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    if (i == 0 || key(sides_[i]) != key(sides_[i - 1])) {
      result_.faces.push_back(sides_[i]);
      result_.faces.back().distance = length_of(seen_from_k(sides_[i].l));
    } else {
      result_.faces.back().length += sides_[i].length;
    }
  }
}

}  // namespace

VoronoiBoxes voronoi_boxes(const Mesh& mesh) { return BoxCutter(mesh).cut(); }

std::vector<double> box_areas(const Mesh& mesh, const VoronoiBoxes& boxes) {
  std::vector<double> areas(mesh.vertex_count(), 0.0);
  for (const VoronoiBox& box : boxes.boxes) areas[box.vertex.index()] += box.area;
  return areas;
}

}  // namespace lepp
