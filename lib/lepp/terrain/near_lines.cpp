#include "lepp/terrain/near_lines.hpp"

#include <algorithm>
#include <cmath>

namespace lepp {

namespace {

constexpr double tile = 16;  // cells
// How far beyond the grid a part of an outline may be: squares around samples that stand alone.
constexpr double beyond = 1;

}  // namespace

NearLines::NearLines(const HeightGrid& grid)
    : aspect_(grid.aspect()),
      columns_(grid.columns - 1.0),
      lines_(grid.rows - 1.0),
      across_(static_cast<std::size_t>(columns_ / tile) + 1),
      along_(static_cast<std::size_t>(lines_ / tile) + 1),
      marked_(across_ * along_) {}

// Those that the boxes of pieces of a tile's length meet, the boxes widened by `margin` cells.
template <class Visit>
void NearLines::for_each_tile(Point a, Point b, double margin, Visit visit) const {
  a.y /= aspect_;
  b.y /= aspect_;
  const Point step = b - a;
  // The part of the segment that is not beyond a side of the grid, by parameters from 0 to 1.
  double from = 0, to = 1;
  const auto clip = [&](double start, double length, double most) {
    const double low = -beyond - margin - start, high = most + beyond + margin - start;
    if (length == 0) {
      if (low > 0 || high < 0) to = -1;
      return;
    }
    from = std::max(from, std::min(low / length, high / length));
    to = std::min(to, std::max(low / length, high / length));
  };
  clip(a.x, step.x, columns_);
  clip(a.y, step.y, lines_);
  if (from > to) return;
  const double length = (to - from) * std::max(std::abs(step.x), std::abs(step.y));
  const auto pieces = static_cast<std::size_t>(length / tile) + 1;
  const auto tile_of = [](double x, double shift, std::size_t count) {
    return static_cast<std::size_t>(
        std::clamp(std::floor((x + shift) / tile), 0.0, double(count - 1)));
  };
  for (std::size_t i = 0; i < pieces; ++i) {
    const Point p = a + (from + (to - from) * double(i) / double(pieces)) * step;
    const Point q = a + (from + (to - from) * double(i + 1) / double(pieces)) * step;
    const auto [west, east] = std::minmax(p.x, q.x);
    const auto [south, north] = std::minmax(p.y, q.y);
    for (std::size_t y = tile_of(south, -margin, along_); y <= tile_of(north, margin, along_);
         ++y) {
      for (std::size_t x = tile_of(west, -margin, across_); x <= tile_of(east, margin, across_);
           ++x)
        visit(y * across_ + x);
    }
  }
}

// Places on lines with an end this far away, in cells, are rounded too much to tell their tiles.
bool NearLines::is_far(Point p) const {
  constexpr double far = 0x1p+40;
  return std::max(std::abs(p.x), std::abs(p.y / aspect_)) > far;
}

// True if both are beyond one side of the grid, and so what is between.
bool NearLines::is_beside_grid(Point a, Point b) const {
  const double far = beyond + 1;
  const auto is_beyond = [&](double p, double q, double most) {
    return std::max(p, q) < -far || std::min(p, q) > most + far;
  };
  return is_beyond(a.x, b.x, columns_) || is_beyond(a.y / aspect_, b.y / aspect_, lines_);
}

void NearLines::add(Point a, Point b) {
  if ((is_far(a) || is_far(b)) && !is_beside_grid(a, b)) all_marked_ = true;
  if (all_marked_) return;
  for_each_tile(a, b, 1, [&](std::size_t i) { marked_[i] = true; });
}

bool NearLines::is_near(Point a, Point b) const {
  bool near = all_marked_;
  for_each_tile(a, b, 0, [&](std::size_t i) { near = near || marked_[i]; });
  return near;
}

}  // namespace lepp
