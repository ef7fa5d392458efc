#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "lepp/terrain/world_tin.hpp"
#include "support/hand_made.hpp"

namespace lepp::test {

/// The square of hand_made.hpp with a height per corner.
inline WorldTin small_tin() {
  WorldTin tin;
  tin.mesh = square();
  tin.heights = {0, 1.5, -2, 0.1};
  tin.title = "small";
  return tin;
}

/// A square with a square hole, and the same far from the origin: 8 triangles.
inline WorldTin ring(Point corner = {0, 0}) {
  std::vector<Point> points = {{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {2, 1}, {2, 2}, {1, 2}};
  for (Point& p : points) p = p + corner;
  WorldTin tin;
  tin.mesh = from_triangles(
      points,
      {{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 6, 5}, {2, 3, 6}, {3, 7, 6}, {3, 0, 7}, {0, 4, 7}});
  tin.heights.assign(8, 10);
  tin.title = "ring";
  return tin;
}

inline constexpr const char* utm =
    "PROJCS[\"WGS 84 / UTM zone 11N\",GEOGCS[\"WGS 84\",AUTHORITY[\"EPSG\",\"4326\"]],"
    "AUTHORITY[\"EPSG\",\"32611\"]]";

/// Reads numbers from the bytes of a file.
class Bytes {
 public:
  Bytes(std::string text, std::endian order) : text_(std::move(text)), order_(order) {}

  template <class Number>
  Number next() {
    std::array<char, sizeof(Number)> bytes;
    REQUIRE(at_ + bytes.size() <= text_.size());
    std::memcpy(bytes.data(), text_.data() + at_, bytes.size());
    if (order_ != std::endian::native) std::reverse(bytes.begin(), bytes.end());
    at_ += bytes.size();
    return std::bit_cast<Number>(bytes);
  }
  std::string text(std::size_t n) {
    REQUIRE(at_ + n <= text_.size());
    at_ += n;
    return text_.substr(at_ - n, n);
  }
  void go_to(std::size_t at) { at_ = at; }
  bool at_end() const { return at_ == text_.size(); }

 private:
  std::string text_;
  std::endian order_;
  std::size_t at_ = 0;
};

}  // namespace lepp::test
