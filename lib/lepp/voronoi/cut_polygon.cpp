#include "lepp/voronoi/cut_polygon.hpp"

#include <algorithm>

namespace lepp {

//      p2 -------- p1        The line meets sides p0 p1 and p2 p3 in x and y. What is kept is
//      |           |         p0 x y p3, and x y is the new side. Where the line runs through a
//   ---y-----------x---      corner, that corner is x or y.
//      |  inside   |
//      p3 -------- p0
void CutPolygon::cut_along_line(Side side) {
  if (kept_.size() < 2 * count_) kept_.resize(4 * count_);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const Corner& here = corners_[i];
    const Corner& next = after(i);
    const double s = beyond_[i], s_next = beyond_[i + 1 == count_ ? 0 : i + 1];
    if (s <= 0) kept_[kept++] = {here.at, s == 0 && s_next > 0 ? side : here.side};
    if ((s < 0 && s_next > 0) || (s > 0 && s_next < 0)) {
      const Point crossing = here.at + (s / (s - s_next)) * (next.at - here.at);
      kept_[kept++] = {crossing, s < 0 ? side : here.side};
    }
  }
  corners_.swap(kept_);
  count_ = kept;
  if (beyond_.size() < count_) beyond_.resize(2 * count_);
}

double CutPolygon::area() const {
  double twice = 0;
  for (std::size_t i = 2; i < count_; ++i) {
    twice += cross(corners_[i - 1].at - corners_[0].at, corners_[i].at - corners_[0].at);
  }
  return 0.5 * twice;
}

}  // namespace lepp
