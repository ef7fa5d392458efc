#pragma once

#include <cmath>
#include <cstdint>

#include "lepp/geometry/point.hpp"
#include "lepp/terrain/height_grid.hpp"

namespace lepp {

/// A sample of a grid: its column, and its line counted from the south.
struct Sample {
  std::uint32_t column = 0, line = 0;
  friend bool operator==(const Sample&, const Sample&) = default;
};

/// A corner of a triangle above a grid: whole numbers of `column` and `line` are samples.
struct TerrainCorner {
  double column = 0, line = 0, height = 0;
};

/// Places nearer to a sample than this, in cells, are meant to be there: a file's world coordinates
/// and true cell sizes leave rounding behind.
inline constexpr double same_place = 1e-9;

/// Grid space as columns and lines. Where cells are not square, the ordinate of a sample is
/// rounded.
class SampleSpace {
 public:
  explicit SampleSpace(const HeightGrid& grid) : grid_(grid), aspect_(grid.aspect()) {}

  TerrainCorner corner(Point p, double height) const {
    return {snapped(p.x), snapped(aspect_ == 1 ? p.y : p.y / aspect_), height};
  }
  /// A corner that is nearer to a sample's column or line than `same_place` is put there.
  static TerrainCorner snapped(const TerrainCorner& c) {
    return {snapped(c.column), snapped(c.line), c.height};
  }
  Point place(Sample s) const { return grid_.sample(s.column, s.line); }
  double height(Sample s) const { return grid_.height(s.column, grid_.row_of_line(s.line)); }
  /// The sample nearest to a place.
  Sample nearest(Point p) const {
    return {whole(p.x, grid_.columns), whole(aspect_ == 1 ? p.y : p.y / aspect_, grid_.rows)};
  }
  Sample nearest(const TerrainCorner& c) const {
    return {whole(c.column, grid_.columns), whole(c.line, grid_.rows)};
  }
  static bool is_at(const TerrainCorner& corner, Sample s) {
    return corner.column == s.column && corner.line == s.line;
  }

 private:
  static double snapped(double x) {
    const double near = static_cast<double>(static_cast<std::int64_t>(x + 0.5));
    return std::abs(x - near) < same_place ? near : x;
  }
  static std::uint32_t whole(double x, std::uint32_t count) {
    if (!(x > 0)) return 0;
    const double last = count - 1;
    return static_cast<std::uint32_t>(x + 0.5 < last ? x + 0.5 : last);
  }
  const HeightGrid& grid_;
  double aspect_;
};

}  // namespace lepp
