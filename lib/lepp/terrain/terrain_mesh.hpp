#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lepp/terrain/sample_space.hpp"
#include "lepp/terrain/terrain_domain.hpp"
#include "lepp/terrain/tin.hpp"
#include "lepp/terrain/triangle_scan.hpp"
#include "lepp/triangulation/cavity.hpp"

namespace lepp {

/// The TIN while it is worked on: the mesh of a domain, heights at its vertices, and the worst
/// sample of every triangle. Both ways of simplifying insert through it.
class TerrainMesh {
 public:
  /// The domain's own triangulation.
  TerrainMesh(const HeightGrid& grid, const TerrainDomain& domain);

  const Mesh& mesh() const { return tin_.mesh; }
  Mesh& mesh() { return tin_.mesh; }
  const Tin& tin() const { return tin_; }
  Tin take() { return std::move(tin_); }
  const SampleSpace& space() const { return space_; }
  const TriangleScan& scan() const { return scan_; }

  const WorstSample& worst(TriangleId t) const { return worst_[t.index()]; }
  double error(TriangleId t) const { return worst(t).error; }
  /// Looks at the samples of triangles that changed.
  void rescan(std::span<const TriangleId> changed);

  TerrainCorner corner(VertexId v) const {
    return space_.corner(mesh().point(v), tin_.heights[v.index()]);
  }
  /// The height that a vertex at `p` gets: a sample's own, else the grid's.
  double height_of(Point p) const;

  /// False for sides of the domain that have to stay whole.
  bool may_cut(HalfEdge e) const;
  /// True if the height of each place on `e` is asked for by a line.
  bool is_hard(HalfEdge e) const;

  /// Inserts a vertex at a sample that is in `t`, on a constrained edge of it if need be.
  /// \return false if that is not possible: a vertex is there, or the edge may not be cut
  /// \param changed  triangles with other corners are appended; rescan() is the caller's
  bool insert(TriangleId t, Sample s, std::vector<TriangleId>& changed);

  /// Gives vertices that the mesh has and heights() has not their heights.
  void add_heights();
  /// The same for a vertex that moved.
  void set_height(VertexId v) { tin_.heights[v.index()] = height_of(mesh().point(v)); }

 private:
  void scan_triangle(TriangleId t);
  void put_on_line(VertexId v);
  std::optional<HalfEdge> constrained_edge_at(TriangleId t, Point p) const;
  bool cut_at(HalfEdge e, Point p, std::vector<TriangleId>& changed);

  const HeightGrid& grid_;
  SampleSpace space_;
  TriangleScan scan_;
  Tin tin_;
  std::vector<std::uint8_t> kept_;  // by vertex: the ends of edges that may not be cut
  std::vector<std::uint8_t> hard_;  // by vertex: its height is asked for by a line
  std::vector<WorstSample> worst_;  // by triangle
  Cavity cavity_;
};

}  // namespace lepp
