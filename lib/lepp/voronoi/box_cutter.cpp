#include "lepp/voronoi/box_cutter.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

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

}  // namespace

void BoxCutter::cut(VertexId k, VoronoiBoxes& into) {
  result_ = &into;
  k_ = k;
  x_k_ = mesh_.point(k);
  const std::uint32_t first = corners_.first_box(k.index()),
                      end = corners_.first_box(k.index() + 1);
  for (std::uint32_t box = first; box < end; ++box) cut_box(box);
  if (faces_ == Faces::make) add_faces();
}

// Nearly always one fan has all corners of the box. Else corners that a fan had are passed by.
void BoxCutter::cut_box(std::uint32_t box) {
  region_ = corners_.region(box);
  area_ = {};
  const auto first_piece = static_cast<std::uint32_t>(result_->piece_triangle.size());
  const auto corners = corners_.corners(box);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i != 0 && is_done_[i]) continue;
    gather_fan(corners[i]);
    for (std::size_t sector = 0; sector < sectors_.size(); ++sector) cut_sector(sector);
    if (sectors_.size() == corners.size()) break;
    if (i == 0) is_done_.assign(corners.size(), false);
    for (const TriangleCorner corner : sectors_) {
      is_done_[static_cast<std::size_t>(std::ranges::lower_bound(corners, corner) -
                                        corners.begin())] = true;
    }
  }
  const auto pieces = static_cast<std::uint32_t>(result_->piece_triangle.size()) - first_piece;
  result_->boxes.push_back({k_, region_, area_.value(), first_piece, pieces});
}

// The whole fan that the corner belongs to; if walls end it, from wall to wall.
void BoxCutter::gather_fan(TriangleCorner corner) {
  HalfEdge first{corner.triangle, previous_corner(corner.corner)};
  is_closed_ = gather_from(first);
  if (is_closed_ || is_wall(mesh_, first)) return;
  while (!is_wall(mesh_, first)) first = next_edge(*mesh_.twin(first));  // clockwise
  gather_from(first);
}

// Turns counter-clockwise from `first`, which leaves k, up to a wall.
// Returns true if it came back to `first` instead.
bool BoxCutter::gather_from(HalfEdge first) {
  const auto add_ray = [&](VertexId end) {
    rays_.push_back({end, nearer_to_origin_than(seen_from_k(end))});
  };
  rays_.clear();
  sectors_.clear();
  HalfEdge leaving = first;
  do {
    add_ray(mesh_.destination(leaving));
    sectors_.push_back({leaving.triangle, next_corner(leaving.edge)});
    const HalfEdge arriving = previous_edge(leaving);
    if (is_wall(mesh_, arriving)) {
      add_ray(mesh_.origin(arriving));
      return false;
    }
    leaving = *mesh_.twin(arriving);
  } while (leaving != first);
  return true;
}

// The sector starts in its own triangle. Where its part there ends at an edge and not at a
// bisector, it goes on beyond the edge, unless that is a wall.
void BoxCutter::cut_sector(std::size_t sector) {
  find_neighbours(sector);
  triangles_.assign(1, sectors_[sector].triangle);
  for (std::size_t i = 0; i < triangles_.size(); ++i) {  // ends: each triangle enters once
    const TriangleId t = triangles_[i];
    if (!cut_part(t, sectors_[sector])) continue;
    follow_part(t);
    keep_part(t);
  }
}

// A neighbour at 90 degrees or more from each ray of the sector is never nearer than k. So we turn
// both ways as far as that, or to a wall: what lies beyond a wall, near as it may be, does not
// bound the box on this side.
void BoxCutter::find_neighbours(std::size_t sector) {
  const std::size_t count = rays_.size();
  const auto after = [&](std::size_t ray) { return ray + 1 == count ? 0 : ray + 1; };
  const auto before = [&](std::size_t ray) { return ray == 0 ? count - 1 : ray - 1; };
  const std::size_t a = sector, b = after(sector);
  const auto add_if_near = [&](std::size_t own, std::size_t ray) {
    if (dot(rays_[own].nearer.normal, rays_[ray].nearer.normal) <= 0) return false;
    neighbours_.push_back(static_cast<std::uint32_t>(ray));
    return true;
  };
  neighbours_.clear();
  for (const std::size_t ray : {a, b}) {
    neighbours_.push_back(static_cast<std::uint32_t>(ray));
    if (faces_ == Faces::make) sides_.push_back({k_, rays_[ray].end, region_, 0, 0});
  }
  for (std::size_t ray = a; is_closed_ || ray != 0;) {  // clockwise from a
    ray = before(ray);
    if (ray == b || !add_if_near(a, ray)) break;
  }
  for (std::size_t ray = b; is_closed_ || ray + 1 != count;) {  // counter-clockwise from b
    ray = after(ray);
    if (ray == a || !add_if_near(b, ray)) break;
  }
}

// What of triangle t lies in the sector and is nearer to k than to its neighbours; false if nothing
// does. In its own triangle, which nearly always is acute, the first two cuts are one step.
bool BoxCutter::cut_part(TriangleId t, TriangleCorner own) {
  const Point a = neighbour(0).nearer.normal, b = neighbour(1).nearer.normal;
  std::uint32_t done = 0;
  if (t != own.triangle) {
    const auto& v = mesh_.vertices(t);
    part_.start_with(seen_from_k(v[0]), seen_from_k(v[1]), seen_from_k(v[2]));
    const Side ray{Side::Kind::ray, 0};
    if (!part_.keep(left_of_ray(a), ray) || !part_.keep(right_of_ray(b), ray)) return false;
  } else if (part_.start_with_acute(a, b, own.corner)) {
    done = 2;
  } else {
    part_.start_with({0, 0}, a, b, own.corner);
  }
  for (; done < neighbours_.size(); ++done) {
    if (!part_.keep(neighbour(done).nearer, {Side::Kind::bisector, done})) return false;
  }
  return true;
}

void BoxCutter::follow_part(TriangleId t) {
  for (const CutPolygon::Corner& corner : part_.corners()) {
    if (corner.side.kind != Side::Kind::edge) continue;
    const HalfEdge e{t, corner.side.index};
    if (mesh_.origin(e) == k_ || mesh_.destination(e) == k_) continue;  // another sector
    if (is_wall(mesh_, e)) continue;
    const TriangleId next = mesh_.twin(e)->triangle;
    if (std::ranges::find(triangles_, next) == triangles_.end()) triangles_.push_back(next);
  }
}

void BoxCutter::keep_part(TriangleId t) {
  const double area = part_.area();
  const bool is_own = t == triangles_.front();  // what is next to k is k's, however thin
  if (!is_own && area <= rounding_area * longest_squared_side(mesh_.corners(t))) return;
  area_.add(area);
  for (const CutPolygon::Corner& corner : part_.corners()) {
    result_->corners.push_back(x_k_ + corner.at);
  }
  result_->piece_begin.push_back(static_cast<std::uint32_t>(result_->corners.size()));
  result_->piece_triangle.push_back(t);
  if (faces_ == Faces::leave_out) return;
  for (std::size_t i = 0; i < part_.corners().size(); ++i) {
    const CutPolygon::Corner& corner = part_.corners()[i];
    if (corner.side.kind != Side::Kind::bisector) continue;
    const double length = length_of(part_.after(i).at - corner.at);
    sides_.push_back({k_, neighbour(corner.side.index).end, region_, length, 0});
  }
}

// One face per edge and region, though cocircular vertices leave it no length; measured once, from
// the vertex that comes first.
void BoxCutter::add_faces() {
  std::erase_if(sides_, [](const VoronoiFace& side) { return side.l < side.k; });
  const auto key = [](const VoronoiFace& side) { return std::tuple(side.l, side.region); };
  std::ranges::stable_sort(sides_, {}, key);
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    if (i == 0 || key(sides_[i]) != key(sides_[i - 1])) {
      result_->faces.push_back(sides_[i]);
      result_->faces.back().distance = length_of(seen_from_k(sides_[i].l));
    } else {
      result_->faces.back().length += sides_[i].length;
    }
  }
  sides_.clear();
}

}  // namespace lepp
