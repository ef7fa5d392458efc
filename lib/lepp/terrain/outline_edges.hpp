#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "lepp/terrain/outline.hpp"

namespace lepp {

/// Counter-clockwise, from a sample to one of its eight neighbours.
enum class Direction : std::uint8_t {
  east,
  north_east,
  north,
  north_west,
  west,
  south_west,
  south,
  south_east,
};

/// A side or diagonal of a cell, directed, with the covered area on its left. In order of starts,
/// by lines; 8 bytes.
class OutlineEdge {
 public:
  OutlineEdge(LatticePoint start, Direction direction)
      : code_(std::uint64_t{start.line} << 32 | std::uint64_t{start.column} << 3 |
              static_cast<std::uint64_t>(direction)) {}

  LatticePoint start() const {
    return {static_cast<std::uint32_t>(code_ & 0xFFFFFFFFU) >> 3,
            static_cast<std::uint32_t>(code_ >> 32)};
  }
  Direction direction() const { return static_cast<Direction>(code_ & 7); }
  LatticePoint end() const {
    constexpr std::array<int, 8> east = {1, 1, 0, -1, -1, -1, 0, 1};
    constexpr std::array<int, 8> north = {0, 1, 1, 1, 0, -1, -1, -1};
    const auto d = static_cast<std::size_t>(code_ & 7);
    const LatticePoint from = start();
    return {from.column + static_cast<std::uint32_t>(east[d]),
            from.line + static_cast<std::uint32_t>(north[d])};
  }
  friend auto operator<=>(const OutlineEdge&, const OutlineEdge&) = default;

 private:
  std::uint64_t code_;
};

/// The edge that follows each one in its ring. Where rings touch, each keeps to its own part of the
/// covered area: it turns as far to the left as it can.
/// \pre  sorted, and the boundary of an area
std::vector<std::uint32_t> next_edges(const std::vector<OutlineEdge>& edges);

}  // namespace lepp
