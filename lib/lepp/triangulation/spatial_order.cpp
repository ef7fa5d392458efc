#include "lepp/triangulation/spatial_order.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace lepp {

namespace {

// A Hilbert curve through a grid of 2^16 x 2^16 cells, four bits of each coordinate at a time. The
// curve enters a block in one of four ways: as it is (0), with both coordinates complemented (1),
// exchanged (2), or both (3).
struct Block {
  std::uint8_t position;  // of a 4 x 4 bit cell in the block, 0 to 255
  std::uint8_t way;       // how the curve enters the cell
};

constexpr auto blocks = [] {
  std::array<std::array<Block, 256>, 4> table{};
  for (unsigned entered = 0; entered < 4; ++entered) {
    for (unsigned cell = 0; cell < 256; ++cell) {
      unsigned way = entered, position = 0;
      for (unsigned bit = 4; bit-- > 0;) {
        unsigned x = (cell >> (4 + bit) & 1U) ^ (way & 1U);
        unsigned y = (cell >> bit & 1U) ^ (way & 1U);
        if ((way & 2U) != 0) std::swap(x, y);
        position = position << 2 | ((3 * x) ^ y);
        if (y == 0) way ^= x != 0 ? 3U : 2U;
      }
      table[entered][cell] = {static_cast<std::uint8_t>(position), static_cast<std::uint8_t>(way)};
    }
  }
  return table;
}();

std::uint32_t hilbert_position(std::uint32_t x, std::uint32_t y) {
  std::uint32_t position = 0, way = 0;
  for (unsigned shift = 16; shift > 0;) {
    shift -= 4;
    const Block block = blocks[way][(x >> shift & 15U) << 4 | (y >> shift & 15U)];
    position = position << 8 | block.position;
    way = block.way;
  }
  return position;
}

// An item is a position on the curve, in the high half, and the index of a point.
using Item = std::uint64_t;
std::uint32_t index_of(Item item) { return static_cast<std::uint32_t>(item); }

constexpr std::size_t few = 64;           // sorted by coordinates
constexpr std::size_t radix_pays = 2048;  // from here on counting beats comparing

class SpatialSort {
 public:
  explicit SpatialSort(std::span<const Point> points) : points_(points), items_(points.size()) {
    for (std::size_t i = 0; i < items_.size(); ++i) items_[i] = i;
    spare_.resize(items_.size());
  }

  std::vector<std::uint32_t> run() {
    ranges_.push_back({0, items_.size()});
    while (!ranges_.empty()) {  // a range is divided into shorter ones, or ends up sorted
      const auto [begin, end] = ranges_.back();
      ranges_.pop_back();
      divide(begin, end);
    }
    spare_ = {};
    std::vector<std::uint32_t> order(items_.size());
    std::ranges::transform(items_, order.begin(), index_of);
    return order;
  }

 private:
  struct Range {
    std::size_t begin, end;
  };

  void divide(std::size_t begin, std::size_t end) {
    if (end - begin <= few) {
      std::sort(items_.begin() + static_cast<std::ptrdiff_t>(begin),
                items_.begin() + static_cast<std::ptrdiff_t>(end), [&](Item i, Item j) {
                  const Point p = points_[index_of(i)], q = points_[index_of(j)];
                  return p != q ? p < q : index_of(i) < index_of(j);
                });
      return;
    }
    if (!set_positions(begin, end)) return;  // one point many times, by index already
    if (end - begin < radix_pays) {
      std::sort(items_.begin() + static_cast<std::ptrdiff_t>(begin),
                items_.begin() + static_cast<std::ptrdiff_t>(end));
    } else {
      radix_sort(begin, end);
    }
    for (std::size_t i = begin; i < end;) {
      std::size_t j = i + 1;
      while (j < end && items_[i] >> 32 == items_[j] >> 32) ++j;
      if (j - i > 1) ranges_.push_back({i, j});
      i = j;
    }
  }

  // False if all points of the range are the same.
  bool set_positions(std::size_t begin, std::size_t end) {
    Point low = points_[index_of(items_[begin])], high = low;
    for (std::size_t i = begin; i < end; ++i) {
      const Point p = points_[index_of(items_[i])];
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double size = std::max(high.x - low.x, high.y - low.y);
    if (size == 0) return false;
    const double scale = 65535.0 / size;
    // The curve goes through the left half of its square first. So the longer side is laid along x,
    // and the line between the halves divides the points near the middle (merge_halves.hpp).
    const bool tall = high.y - low.y > high.x - low.x;
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t index = index_of(items_[i]);
      const Point p = points_[index];
      const auto x = static_cast<std::uint32_t>((p.x - low.x) * scale);
      const auto y = static_cast<std::uint32_t>((p.y - low.y) * scale);
      items_[i] = Item{tall ? hilbert_position(y, x) : hilbert_position(x, y)} << 32 | index;
    }
    return true;
  }

  // Three stable passes of 11, 11 and 10 bits; the odd number of passes ends in spare_.
  void radix_sort(std::size_t begin, std::size_t end) {
    Item* from = items_.data() + begin;
    Item* to = spare_.data() + begin;
    const std::size_t count = end - begin;
    std::array<std::array<std::uint32_t, 2048>, 3> places{};
    for (std::size_t i = 0; i < count; ++i) {
      ++places[0][from[i] >> 32 & 2047U];
      ++places[1][from[i] >> 43 & 2047U];
      ++places[2][from[i] >> 54];
    }
    for (unsigned pass = 0; pass < 3; ++pass) {
      std::uint32_t sum = 0;
      for (std::uint32_t& place : places[pass]) sum += std::exchange(place, sum);
      const unsigned shift = 32 + 11 * pass;
      for (std::size_t i = 0; i < count; ++i) {
        to[places[pass][from[i] >> shift & 2047U]++] = from[i];
      }
      std::swap(from, to);
    }
    std::copy(from, from + count, items_.data() + begin);
  }

  std::span<const Point> points_;
  std::vector<Item> items_, spare_;
  std::vector<Range> ranges_;
};

}  // namespace

std::vector<std::uint32_t> spatial_order(std::span<const Point> points) {
  return SpatialSort(points).run();
}

}  // namespace lepp
