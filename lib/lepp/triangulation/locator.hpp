#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lepp/triangulation/locate.hpp"
#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Finds triangles without a hint, also outside the mesh and in its holes.
///
/// Each triangle stands in the cells that its bounding box meets, in a grid of cells just larger
/// than that box: at most four entries a triangle, whatever its size and shape. There is a grid for
/// each power of four of width and of height that occurs; all share one flat hash table. A point is
/// in one cell of each grid. docs/algorithms/locate.md counts what that costs.
class Locator {
 public:
  /// \pre  M1 to M3. `mesh` stays where it is and as it is while this is in use. Cost O(n).
  explicit Locator(const Mesh& mesh);

  /// The triangle that contains `p`, or nothing if `p` is outside the mesh.
  /// Cost O(1) expected where most triangles are not slivers askew to both axes.
  std::optional<Location> locate(Point p, LocateSteps* steps = nullptr) const;

  /// How many entries the table has.
  std::size_t size() const { return entries_.size(); }

 private:
  // Columns of width extent / 4^x and rows of height extent / 4^y.
  struct Grid {
    std::uint32_t x = 0, y = 0;
  };
  struct Box {
    Point low, high;
  };
  struct Cells {
    Grid grid;
    std::array<std::int64_t, 2> columns, rows;  // first and last
  };

  Box box_of(TriangleId t) const;
  Cells cells_of(const Box& box) const;
  template <class Visit>
  void for_each_bucket(const Cells& cells, Visit visit) const;
  std::uint32_t bucket_of(Grid grid, std::int64_t column, std::int64_t row) const;
  std::span<const TriangleId> bucket_at(Grid grid, Point p) const;
  void collect_grids(const std::vector<double>& areas);

  const Mesh& mesh_;
  Box all_;
  double extent_ = 1;
  std::vector<Grid> grids_;  // those in use, the one that covers most first
  int bucket_bits_ = 1;
  std::vector<std::uint32_t> starts_;  // of each bucket in entries_, and the end
  std::vector<TriangleId> entries_;
};

}  // namespace lepp
