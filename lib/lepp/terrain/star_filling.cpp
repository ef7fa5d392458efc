#include "lepp/terrain/star_filling.hpp"

#include "lepp/geometry/predicates.hpp"

namespace lepp {

bool StarFilling::fill(const AngleTest& angle) {
  triangles_.clear();
  left_.resize(corners_.size());
  for (std::size_t i = 0; i < left_.size(); ++i) left_[i] = i;
  while (left_.size() >= 3) {  // ends: each turn cuts an ear off, or returns
    const std::size_t n = left_.size();
    std::size_t i = 0;
    const auto at = [&](std::size_t k) { return left_[k < n ? k : k - n]; };
    while (i < n && !is_ear(at(i + n - 1), at(i), at(i + 1))) ++i;
    if (i == n) return false;
    const std::array<std::size_t, 3> ear{at(i + n - 1), at(i), at(i + 1)};
    if (angle.is_below(corners_[ear[0]].place, corners_[ear[1]].place, corners_[ear[2]].place)) {
      return false;
    }
    triangles_.push_back(ear);
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return true;
}

Sides StarFilling::hard_sides(const std::array<std::size_t, 3>& triangle) const {
  std::uint32_t sides = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t from = triangle[(i + 1) % 3], to = triangle[(i + 2) % 3];
    const bool is_rim = to == (from + 1 == corners_.size() ? 0 : from + 1);
    if (is_rim && corners_[from].hard) sides |= 1U << i;
  }
  return static_cast<Sides>(sides);
}

bool StarFilling::is_ear(std::size_t before, std::size_t at, std::size_t after) const {
  const Point a = corners_[before].place, b = corners_[at].place, c = corners_[after].place;
  if (orient2d(a, b, c) <= 0) return false;
  for (const std::size_t i : left_) {
    if (i == before || i == at || i == after) continue;
    if (incircle(a, b, c, corners_[i].place) > 0) return false;
  }
  return true;
}

}  // namespace lepp
