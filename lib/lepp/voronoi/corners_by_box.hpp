#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// The corner of a triangle at some vertex.
struct TriangleCorner {
  TriangleId triangle;
  std::uint32_t corner = 0;
  friend constexpr auto operator<=>(TriangleCorner, TriangleCorner) = default;
};

/// For each vertex and each region around it, the corners of triangles of that region that meet
/// there, of all fans. The pair (vertex, region) is a box; boxes are numbered by vertex, then
/// region.
class CornersByBox {
 public:
  /// \pre  M1.  Cost O(triangles log(degree))
  explicit CornersByBox(const Mesh& mesh);

  std::size_t box_count() const { return regions_.size(); }
  std::uint32_t first_box(std::size_t vertex) const { return first_box_[vertex]; }
  SurfaceId region(std::uint32_t box) const { return regions_[box]; }
  /// In order of triangles.
  std::span<const TriangleCorner> corners(std::uint32_t box) const {
    return std::span(corners_).subspan(begin_[box], begin_[box + 1] - begin_[box]);
  }

 private:
  std::vector<std::uint32_t> first_box_;  // vertices + 1
  std::vector<SurfaceId> regions_;        // boxes
  std::vector<std::uint32_t> begin_;      // boxes + 1; 3 max_triangles fit
  std::vector<TriangleCorner> corners_;
};

}  // namespace lepp
