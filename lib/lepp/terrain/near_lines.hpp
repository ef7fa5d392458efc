#pragma once

#include <cstdint>
#include <vector>

#include "lepp/terrain/height_grid.hpp"

namespace lepp {

/// Tells segments of an outline that no line comes near, by tiles of 16 x 16 cells: those need not
/// be looked at where lines are cut. In grid space.
class NearLines {
 public:
  explicit NearLines(const HeightGrid& grid);

  /// Remembers the tiles within a cell of a line.
  void add(Point a, Point b);
  /// False only if no part of a line is within a cell of segment ab.
  bool is_near(Point a, Point b) const;

 private:
  bool is_far(Point p) const;
  bool is_beside_grid(Point a, Point b) const;
  template <class Visit>
  void for_each_tile(Point a, Point b, double margin, Visit visit) const;

  double aspect_;
  double columns_, lines_;      // of samples, less 1
  std::size_t across_, along_;  // tiles
  std::vector<bool> marked_;
  bool all_marked_ = false;  // by a line from so far away that its tiles are not known
};

}  // namespace lepp
