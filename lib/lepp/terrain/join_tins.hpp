#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "lepp/terrain/tin.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"

namespace lepp {

/// Tiles put together to one TIN: outline vertices at the same place become one, and edges that two
/// tiles share are edges inside.
class JoinedTin {
 public:
  /// \param shift  from the grid space of the tile to that of the whole
  /// \pre  tiles do not overlap, and have the same vertices where they touch (fix_borders())
  void add(const Tin& tile, Point shift = {});

  /// The TIN in the grid space of the whole; its mesh has M1 to M5, edges between tiles need not be
  /// Delaunay. Entities and groups are those of the tiles, the outline being curve 0.
  /// \throw InputError  no tile, or tiles that overlap
  /// Cost   O(n log n) for n vertices on outlines, else linear. The tiles that were added are gone.
  Tin join(std::string source);

 private:
  VertexId vertex_at(Point p, double height, bool may_be_shared);
  std::vector<Segment> outline() const;

  TriangleSoup soup_;
  std::vector<double> heights_;
  std::map<Point, VertexId> at_;                        // on outlines
  std::vector<std::array<VertexId, 2>> outline_edges_;  // of all tiles, the mesh on the left
};

}  // namespace lepp
