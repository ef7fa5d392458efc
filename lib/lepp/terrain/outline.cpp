#include "lepp/terrain/outline.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "lepp/terrain/fill_notches.hpp"
#include "lepp/terrain/outline_edges.hpp"

namespace lepp {

namespace {

using Word = std::uint64_t;

// Bits of a line of samples or cells, one word more than needed, so that a neighbour always exists.
class Bits {
 public:
  explicit Bits(std::uint32_t columns) : words_(columns / 64 + 2) {}
  std::size_t words() const { return words_.size() - 1; }
  Word& operator[](std::size_t i) { return words_[i]; }
  Word operator[](std::size_t i) const { return words_[i]; }
  // Bit c is that of column c + 1, or of column c - 1.
  Word from_east(std::size_t i) const { return words_[i] >> 1 | words_[i + 1] << 63; }
  Word from_west(std::size_t i) const {
    return words_[i] << 1 | (i == 0 ? 0 : words_[i - 1] >> 63);
  }
  void clear() { std::ranges::fill(words_, 0); }

 private:
  std::vector<Word> words_;
};

template <class Visit>
void for_each_bit(Word word, std::size_t index, Visit visit) {
  for (; word != 0; word &= word - 1) {
    visit(static_cast<std::uint32_t>(64 * index + static_cast<unsigned>(std::countr_zero(word))));
  }
}

// Which samples of a line have data.
template <class Height>
void read_line(std::span<const Height> heights, Bits& bits) {
  for (std::size_t i = 0; 64 * i < heights.size(); ++i) {
    const std::size_t first = 64 * i, count = std::min<std::size_t>(64, heights.size() - first);
    bool any_without = false;
    for (std::size_t k = 0; k < count; ++k) any_without |= std::isnan(heights[first + k]);
    Word word = count == 64 ? ~Word{0} : (Word{1} << count) - 1;
    for (std::size_t k = 0; any_without && k < count; ++k) {
      if (std::isnan(heights[first + k])) word &= ~(Word{1} << k);
    }
    bits[i] = word;
  }
}

void read_line(const HeightGrid& grid, std::uint32_t line, Bits& bits) {
  const std::size_t first = grid.index(0, grid.row_of_line(line));
  grid.heights.visit([&](auto all) { read_line(all.subspan(first, grid.columns), bits); });
}

// Walks over the lines of cells from the south, a word of 64 at a time.
class Scan {
 public:
  explicit Scan(const HeightGrid& grid)
      : grid_(grid),
        south_(grid.columns),
        north_(grid.columns),
        cells_(grid.columns),
        below_(grid.columns) {}

  void run(std::vector<OutlineEdge>& edges, std::vector<LatticePoint>& islands) {
    edges_ = &edges;
    read_line(grid_, 0, south_);
    for (std::uint32_t line = 0; line < grid_.rows; ++line) {
      // between two turns: south_ is line `line`, below_ the cells under it
      if (line + 1 < grid_.rows) read_line(grid_, line + 1, north_);
      else north_.clear();
      for (std::size_t i = 0; i < cells_.words(); ++i) cover_cells(i, line);
      for (std::size_t i = 0; i < cells_.words(); ++i) {
        add_sides(i, line);
        add_islands(i, line, islands);
      }
      std::swap(south_, north_);
      std::swap(below_, cells_);
    }
  }

 private:
  // Cells with three or four samples with data; the longest side of those with three.
  void cover_cells(std::size_t i, std::uint32_t line) {
    const Word sw = south_[i], se = south_.from_east(i);
    const Word nw = north_[i], ne = north_.from_east(i);
    cells_[i] = (sw & se & (nw | ne)) | (nw & ne & (sw | se));
    if ((cells_[i] & ~(sw & se & nw & ne)) == 0) return;
    const auto add = [&](Word word, std::uint32_t east, std::uint32_t north, Direction direction) {
      for_each_bit(word, i, [&](std::uint32_t c) {
        edges_->push_back(OutlineEdge({c + east, line + north}, direction));
      });
    };
    add(cells_[i] & ~ne, 1, 0, Direction::north_west);
    add(cells_[i] & ~nw, 1, 1, Direction::south_west);
    add(cells_[i] & ~se, 0, 0, Direction::north_east);
    add(cells_[i] & ~sw, 0, 1, Direction::south_east);
  }

  // Sides of cells, both ends with data, that one covered cell alone has.
  void add_sides(std::size_t i, std::uint32_t line) {
    const auto add = [&](Word word, std::uint32_t east, std::uint32_t north, Direction direction) {
      for_each_bit(word, i, [&](std::uint32_t c) {
        edges_->push_back(OutlineEdge({c + east, line + north}, direction));
      });
    };
    const Word along = south_[i] & south_.from_east(i), up = south_[i] & north_[i];
    const Word cell = cells_[i], west = cells_.from_west(i), below = below_[i];
    add(along & cell & ~below, 0, 0, Direction::east);
    add(along & below & ~cell, 1, 0, Direction::west);
    add(up & west & ~cell, 0, 0, Direction::north);
    add(up & cell & ~west, 0, 1, Direction::south);
  }

  void add_islands(std::size_t i, std::uint32_t line, std::vector<LatticePoint>& islands) const {
    const Word covered = cells_[i] | cells_.from_west(i) | below_[i] | below_.from_west(i);
    for_each_bit(south_[i] & ~covered, i, [&](std::uint32_t c) { islands.push_back({c, line}); });
  }

  const HeightGrid& grid_;
  Bits south_, north_;  // samples of the line and of the next
  Bits cells_, below_;  // covered cells between them, and below them
  std::vector<OutlineEdge>* edges_ = nullptr;
};

// The corners that are left, numbered, and the edges between them.
void write_rings(const std::vector<OutlineEdge>& edges, const std::vector<std::uint32_t>& next,
                 Outline& outline) {
  constexpr std::uint32_t unset = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(edges.size(), unset);
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    if (next[e] == removed) continue;
    const LatticePoint start = edges[e].start();
    // Copies of a corner follow each other.
    if (outline.corners.empty() || outline.corners.back() != start)
      outline.corners.push_back(start);
    number[e] = static_cast<std::uint32_t>(outline.corners.size() - 1);
  }
  std::vector<bool> done(edges.size(), false);
  for (std::uint32_t first = 0; first < edges.size(); ++first) {
    if (next[first] == removed) continue;
    for (std::uint32_t e = first; !done[e]; e = next[e]) {
      outline.edges.push_back({number[e], number[next[e]]});
      done[e] = true;
    }
  }
}

}  // namespace

Outline outline_of(const HeightGrid& grid) {
  Outline outline;
  std::vector<OutlineEdge> edges;
  Scan(grid).run(edges, outline.islands);
  std::ranges::sort(edges);
  std::vector<std::uint32_t> next = next_edges(edges);
  fill_notches(edges, next);
  write_rings(edges, next, outline);
  return outline;
}

}  // namespace lepp
