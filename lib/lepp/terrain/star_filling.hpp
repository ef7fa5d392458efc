#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "lepp/refine/angle_test.hpp"
#include "lepp/terrain/triangle_scan.hpp"

namespace lepp {

/// The Delaunay triangles that fill a hole, without touching the mesh: what remove_vertex() would
/// leave, up to cocircular corners.
///
///       c-----b              c-----b        the hole's corners in counter-clockwise order; an ear
///      / \   / \            /|    / \       a b c is cut off where no other corner lies in its
///     d---v-*---a   --->   d |  /    a      circle, until a triangle is left
///      \ / \   /            \|/    /
///       e-----f              e----f
class StarFilling {
 public:
  struct Corner {
    Point place;
    TerrainCorner terrain;
    bool hard = false;  ///< the side to the next corner: scans pass over its samples
  };

  std::vector<Corner>& corners() { return corners_; }
  const std::vector<Corner>& corners() const { return corners_; }
  /// Fills the hole between corners().
  /// \return false, and nothing useful, if a triangle has an angle below the bound, or the hole
  ///         cannot be filled
  bool fill(const AngleTest& angle);
  /// The hard sides of a triangle of corners, for scans.
  Sides hard_sides(const std::array<std::size_t, 3>& triangle) const;
  /// Corners of the triangles, as indices.
  std::span<const std::array<std::size_t, 3>> triangles() const { return triangles_; }

 private:
  bool is_ear(std::size_t before, std::size_t at, std::size_t after) const;

  std::vector<Corner> corners_;
  std::vector<std::size_t> left_;
  std::vector<std::array<std::size_t, 3>> triangles_;
};

}  // namespace lepp
