#include "lepp/voronoi/cut_polygon.hpp"

#include <cmath>

namespace lepp {

namespace {

// How far from zero, relative to the size of its terms, normal . q - limit must be to be told from
// it: some tens of roundings of the coordinates and of the products.
constexpr double on_line = 1e-14;

double sum_of_sizes(Point p) { return std::abs(p.x) + std::abs(p.y); }

}  // namespace

void CutPolygon::start_with(Point a, Point b, Point c) {
  corners_ = {{a, {Side::Kind::edge, 2}}, {b, {Side::Kind::edge, 0}}, {c, {Side::Kind::edge, 1}}};
}

bool CutPolygon::keep(const HalfPlane& half_plane, Side side) {
  const double reach = on_line * sum_of_sizes(half_plane.normal);
  beyond_.resize(corners_.size());
  bool any_inside = false, any_beyond = false;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Point q = corners_[i].at;
    const double beyond = dot(half_plane.normal, q) - half_plane.limit;
    const double rounding = reach * sum_of_sizes(q) + on_line * half_plane.limit;
    beyond_[i] = std::abs(beyond) <= rounding ? 0 : beyond;
    any_inside |= beyond_[i] < 0;
    any_beyond |= beyond_[i] > 0;
  }
  if (any_inside && any_beyond) cut_along_line(side);
  return any_inside;
}

//      p2 -------- p1        The line meets sides p0 p1 and p2 p3 in x and y. What is kept is
//      |           |         p0 x y p3, and x y is the new side. Where the line runs through a
//   ---y-----------x---      corner, that corner is x or y.
//      |  inside   |
//      p3 -------- p0
void CutPolygon::cut_along_line(Side side) {
  kept_.clear();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Corner& here = corners_[i];
    const Corner& next = after(i);
    const double s = beyond_[i], s_next = beyond_[i + 1 == corners_.size() ? 0 : i + 1];
    if (s <= 0) kept_.push_back({here.at, s == 0 && s_next > 0 ? side : here.side});
    if ((s < 0 && s_next > 0) || (s > 0 && s_next < 0)) {
      const Point crossing = here.at + (s / (s - s_next)) * (next.at - here.at);
      kept_.push_back({crossing, s < 0 ? side : here.side});
    }
  }
  corners_.swap(kept_);
}

double CutPolygon::area() const {
  double twice = 0;
  for (std::size_t i = 2; i < corners_.size(); ++i) {
    twice += cross(corners_[i - 1].at - corners_[0].at, corners_[i].at - corners_[0].at);
  }
  return 0.5 * twice;
}

}  // namespace lepp
