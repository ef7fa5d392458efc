#include "lepp/triangulation/locator.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>

namespace lepp {

namespace {

// Grids get no finer than this: the number of a cell fits a double and 64 bits.
constexpr int finest = 30;
// A bucket with more triangles is worth a walk first.
constexpr std::size_t crowded = 24;

// The cell of coordinate c. Every step of it is monotonic, rounding included, so a point inside a
// box is in a cell between those of the box's ends.
std::int64_t cell_of(double c, double low, double extent, std::uint32_t level) {
  const double scaled = (c - low) / extent;  // 0 to 1
  return static_cast<std::int64_t>(std::ldexp(scaled, 2 * static_cast<int>(level)));
}

// The finest level whose cells are at least as long as `length`, but for rounding.
std::uint32_t level_of(double length, double extent) {
  if (!(length > 0)) return finest;
  return static_cast<std::uint32_t>(std::clamp(std::ilogb(extent / length) / 2, 0, finest));
}

// Both ends of [low, high], on the finest level that does not need a third cell.
std::array<std::int64_t, 2> span_of(double low, double high, double start, double extent,
                                    std::uint32_t& level) {
  while (true) {  // ends: level 0 has cells 0 and 1
    const std::int64_t first = cell_of(low, start, extent, level);
    const std::int64_t last = cell_of(high, start, extent, level);
    if (last - first <= 1) return {first, last};
    --level;
  }
}

}  // namespace

Locator::Box Locator::box_of(TriangleId t) const {
  const auto [a, b, c] = mesh_.corners(t);
  return {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})},
          {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})}};
}

Locator::Cells Locator::cells_of(const Box& box) const {
  Cells cells;
  Grid& grid = cells.grid;
  grid = {level_of(box.high.x - box.low.x, extent_), level_of(box.high.y - box.low.y, extent_)};
  // Boxes up to 16 times as long as wide go into square cells, so that there are few grids.
  if (grid.x > grid.y) grid.x -= (grid.x - grid.y) % 2;
  else grid.y -= (grid.y - grid.x) % 2;
  cells.columns = span_of(box.low.x, box.high.x, all_.low.x, extent_, grid.x);
  cells.rows = span_of(box.low.y, box.high.y, all_.low.y, extent_, grid.y);
  return cells;
}

std::uint32_t Locator::bucket_of(Grid grid, std::int64_t column, std::int64_t row) const {
  std::uint64_t key = static_cast<std::uint64_t>(column) * 0x9E3779B97F4A7C15U;
  key = (std::rotl(key, 31) ^ static_cast<std::uint64_t>(row)) * 0xBF58476D1CE4E5B9U;
  key = (std::rotl(key, 31) ^ (grid.x << 8 | grid.y)) * 0x94D049BB133111EBU;
  return static_cast<std::uint32_t>(key >> (64 - bucket_bits_));
}

template <class Visit>
void Locator::for_each_bucket(const Cells& cells, Visit visit) const {
  std::array<std::uint32_t, 4> seen{};  // two cells may share a bucket; once is enough
  std::size_t count = 0;
  for (std::int64_t column = cells.columns[0]; column <= cells.columns[1]; ++column) {
    for (std::int64_t row = cells.rows[0]; row <= cells.rows[1]; ++row) {
      const std::uint32_t bucket = bucket_of(cells.grid, column, row);
      bool is_new = true;
      for (std::size_t i = 0; i < count; ++i) is_new = is_new && seen[i] != bucket;
      if (!is_new) continue;
      seen[count++] = bucket;
      visit(bucket);
    }
  }
}

void Locator::collect_grids(const std::vector<double>& areas) {
  std::vector<std::uint32_t> present;
  for (std::uint32_t i = 0; i < areas.size(); ++i) {
    if (areas[i] > 0) present.push_back(i);
  }
  std::ranges::stable_sort(present, std::greater<>(), [&](std::uint32_t i) { return areas[i]; });
  for (const std::uint32_t i : present) grids_.push_back({i / (finest + 1), i % (finest + 1)});
}

Locator::Locator(const Mesh& mesh) : mesh_(mesh) {
  const std::size_t n = mesh.triangle_count();
  all_ = box_of(TriangleId(0U));
  for (const Point p : mesh.points()) {
    all_.low = {std::min(all_.low.x, p.x), std::min(all_.low.y, p.y)};
    all_.high = {std::max(all_.high.x, p.x), std::max(all_.high.y, p.y)};
  }
  extent_ = std::max(all_.high.x - all_.low.x, all_.high.y - all_.low.y);
  bucket_bits_ = std::max(1, static_cast<int>(std::bit_width(2 * n)));
  starts_.assign((std::size_t{1} << bucket_bits_) + 1, 0);

  // What a grid's triangles cover, as a share of the extent squared; a little for any that has one.
  std::vector<double> areas((finest + 1) * (finest + 1), 0);
  for (std::size_t t = 0; t < n; ++t) {
    const Box box = box_of(TriangleId(t));
    const Cells cells = cells_of(box);
    const Point size = box.high - box.low;
    areas[cells.grid.x * (finest + 1) + cells.grid.y] +=
        (size.x / extent_) * (size.y / extent_) + 1e-300;
    for_each_bucket(cells, [&](std::uint32_t bucket) { ++starts_[bucket + 1]; });
  }
  collect_grids(areas);

  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  entries_.resize(starts_.back());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::size_t t = 0; t < n; ++t) {
    for_each_bucket(cells_of(box_of(TriangleId(t))),
                    [&](std::uint32_t bucket) { entries_[next[bucket]++] = TriangleId(t); });
  }
}

std::span<const TriangleId> Locator::bucket_at(Grid grid, Point p) const {
  const std::uint32_t bucket = bucket_of(grid, cell_of(p.x, all_.low.x, extent_, grid.x),
                                         cell_of(p.y, all_.low.y, extent_, grid.y));
  return std::span(entries_).subspan(starts_[bucket], starts_[bucket + 1] - starts_[bucket]);
}

std::optional<Location> Locator::locate(Point p, LocateSteps* steps) const {
  LocateSteps own;
  LocateSteps& counted = steps != nullptr ? *steps : own;
  const bool in_box = all_.low.x <= p.x && p.x <= all_.high.x &&  //
                      all_.low.y <= p.y && p.y <= all_.high.y;
  if (!in_box) return std::nullopt;
  for (const Grid grid : grids_) {
    const auto bucket = bucket_at(grid, p);
    if (bucket.size() > crowded) {
      const WalkEnd end = walk(mesh_, p, bucket[bucket.size() / 2], bucket.size(), counted);
      if (end.found) return location_in(mesh_, end.triangle, p);
    }
    for (const TriangleId t : bucket) {
      ++counted.count;
      if (contains(mesh_, t, p)) return location_in(mesh_, t, p);
    }
  }
  return std::nullopt;
}

}  // namespace lepp
