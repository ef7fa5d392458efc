#include "lepp/bisection/common_part.hpp"

namespace lepp {

CommonPart::CommonPart(const std::array<Point, 3>& triangle, const std::array<Point, 3>& other) {
  const Point start = triangle[0];
  corners_[0] = {{0, 0}, own};
  corners_[1] = {triangle[1] - start, own};
  corners_[2] = {triangle[2] - start, own};
  const std::array<Point, 3> x{other[0] - start, other[1] - start, other[2] - start};
  cut(x[1], x[2], 0);
  cut(x[2], x[0], 1);
  cut(x[0], x[1], 2);
}

// Keeps what is on the left of ab. A convex polygon meets a line twice, so each cut adds one corner
// at most; rounding may make it three crossings, hence room for more.
void CommonPart::cut(Point a, Point b, std::uint32_t edge) {
  std::array<double, 8> beyond{};
  bool any = false;
  for (std::uint32_t i = 0; i < count_; ++i) {
    beyond[i] = cross(corners_[i].at - a, b - a);
    any = any || beyond[i] > 0;
  }
  if (!any) return;
  std::array<Corner, 8> kept;
  std::uint32_t number = 0;
  const auto keep = [&](const Corner& corner) {
    if (number < kept.size()) kept[number++] = corner;
  };
  for (std::uint32_t i = 0; i < count_; ++i) {
    const std::uint32_t next = i + 1 == count_ ? 0 : i + 1;
    const double s = beyond[i], s_next = beyond[next];
    if (s <= 0) keep({corners_[i].at, s == 0 && s_next > 0 ? edge : corners_[i].side});
    if ((s < 0 && s_next > 0) || (s > 0 && s_next < 0)) {
      const Point crossing =
          corners_[i].at + (s / (s - s_next)) * (corners_[next].at - corners_[i].at);
      keep({crossing, s < 0 ? edge : corners_[i].side});
    }
  }
  corners_ = kept;
  count_ = number;
}

double CommonPart::area() const {
  double twice = 0;
  for (std::uint32_t i = 2; i < count_; ++i) {
    twice += cross(corners_[i - 1].at - corners_[0].at, corners_[i].at - corners_[0].at);
  }
  return 0.5 * twice;
}

bool CommonPart::goes_on_across(std::uint32_t edge) const {
  for (std::uint32_t i = 0; i < count_; ++i) {
    if (corners_[i].side == edge) return true;
  }
  return false;
}

}  // namespace lepp
