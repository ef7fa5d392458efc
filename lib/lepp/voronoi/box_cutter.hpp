#pragma once

#include <cstdint>
#include <vector>

#include "lepp/geometry/compensated_sum.hpp"
#include "lepp/voronoi/corners_by_box.hpp"
#include "lepp/voronoi/cut_polygon.hpp"
#include "lepp/voronoi/voronoi_boxes.hpp"

namespace lepp {

/// Cuts the boxes of one vertex after another, fan by fan, and in a fan sector by sector: the
/// sector of a triangle at k is what k sees through that corner.
class BoxCutter {
 public:
  enum class Faces { make, leave_out };

  /// \pre  `corners` belongs to `mesh`, which satisfies M1 to M4; both outlive the cutter
  BoxCutter(const Mesh& mesh, const CornersByBox& corners, Faces faces)
      : mesh_(mesh), corners_(corners), faces_(faces) {}

  /// Appends the boxes of `k`, their pieces, and the faces to neighbours with larger ids.
  void cut(VertexId k, VoronoiBoxes& into);

 private:
  struct Ray {
    VertexId end;
    HalfPlane nearer;  // to k than to `end`; its normal is the ray
  };

  void cut_box(std::uint32_t box);
  void gather_fan(TriangleCorner corner);
  bool gather_from(HalfEdge first);
  void cut_sector(std::size_t sector);
  void find_neighbours(std::size_t sector);
  bool cut_part(TriangleId t, TriangleCorner own);
  void follow_part(TriangleId t);
  void keep_part(TriangleId t);
  void add_faces();

  Point seen_from_k(VertexId v) const { return mesh_.point(v) - x_k_; }
  const Ray& neighbour(std::size_t i) const { return rays_[neighbours_[i]]; }

  const Mesh& mesh_;
  const CornersByBox& corners_;
  Faces faces_;
  VoronoiBoxes* result_ = nullptr;

  // The box that is being cut.
  VertexId k_;
  Point x_k_;  // the origin of all that follows: differences first, for meshes far from zero
  SurfaceId region_;
  CompensatedSum area_;
  std::vector<bool> is_done_;       // per corner of the box, if it has several fans
  std::vector<VoronoiFace> sides_;  // of all boxes of k; several may make one face

  // The fan that is being cut: counter-clockwise, sector i between rays i and i + 1.
  std::vector<Ray> rays_;
  std::vector<TriangleCorner> sectors_;
  bool is_closed_ = false;  // after the last ray comes the first

  // The sector that is being cut.
  std::vector<std::uint32_t> neighbours_;  // rays to those that may bound it; its own two first
  std::vector<TriangleId> triangles_;  // those it may reach, in the order in which it enters them
  CutPolygon part_;                    // its part in one of them
};

}  // namespace lepp
