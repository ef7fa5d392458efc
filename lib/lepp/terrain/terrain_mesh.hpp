#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "lepp/terrain/hard_lines.hpp"
#include "lepp/terrain/sample_space.hpp"
#include "lepp/terrain/terrain_domain.hpp"
#include "lepp/terrain/tin.hpp"
#include "lepp/terrain/triangle_scan.hpp"
#include "lepp/triangulation/cavity.hpp"
#include "lepp/triangulation/remove_vertex.hpp"

namespace lepp {

/// The TIN while it is worked on: the mesh of a domain, heights at its vertices, and the worst
/// sample of every triangle. Both ways of simplifying insert through it.
class TerrainMesh {
 public:
  /// The domain's own triangulation.
  TerrainMesh(const HeightGrid& grid, const TerrainDomain& domain);
  /// A TIN that exists.
  /// \param rounding  how far vertices on lines may be off them, in cells
  TerrainMesh(const HeightGrid& grid, Tin tin, double rounding = 0);

  const Mesh& mesh() const { return state_.tin.mesh; }
  Mesh& mesh() { return state_.tin.mesh; }
  const Tin& tin() const { return state_.tin; }
  Tin take() { return std::move(state_.tin); }
  const SampleSpace& space() const { return space_; }
  const TriangleScan& scan() const { return scan_; }
  const HeightGrid& grid() const { return grid_; }

  /// All that changes, to come back to.
  struct State {
    Tin tin;
    std::vector<std::uint8_t> kept;  ///< by vertex: the ends of edges that may not be cut
    std::vector<WorstSample> worst;  ///< by triangle
  };
  State save() const { return state_; }
  void restore(State state) { state_ = std::move(state); }

  const WorstSample& worst(TriangleId t) const { return state_.worst[t.index()]; }
  double error(TriangleId t) const { return worst(t).error; }
  /// From now on the worst sample of a large triangle need only be one that is off by more than
  /// this, which is much faster to find. Infinite, as at the start: it is the worst one.
  void set_enough(double error) { enough_ = error; }
  /// Looks at the samples of triangles that changed.
  void rescan(std::span<const TriangleId> changed);
  void rescan_all();
  /// Where four corners lie on a circle either diagonal is Delaunay. Of those beside triangles in
  /// `changed` that are off by more than `limit`, takes the one that is off less.
  /// \param changed  the other triangle of each pair is appended
  void choose_diagonals(std::vector<TriangleId>& changed, double limit);

  TerrainCorner corner(VertexId v) const {
    return space_.corner(mesh().point(v), state_.tin.heights[v.index()]);
  }
  /// The height that a vertex at `p` gets: a sample's own, else the grid's.
  double height_of(Point p) const;

  /// False for sides of the domain that have to stay whole.
  bool may_cut(HalfEdge e) const;
  /// The same for a cut by split_constrained_edge(), which cuts all edges of a fan.
  bool may_cut_with_fan(HalfEdge e) const;
  /// True if the height of each place on `e` is asked for by a line.
  bool is_hard(HalfEdge e) const { return lepp::is_hard(state_.tin, e); }
  /// For scans: side `i` of a triangle if `e` is there and hard, else none.
  Sides hard_side(HalfEdge e, std::uint32_t i) const {
    return static_cast<Sides>(is_hard(e) ? 1U << i : 0U);
  }

  /// A triangle as scans see it.
  struct Seen {
    std::array<TerrainCorner, 3> corners;
    Sides hard;
  };
  /// The two triangles that a flip of `e` would make.
  std::array<Seen, 2> flipped(HalfEdge e) const;

  /// The constrained edge of `t` that `p`, a place in it, lies on up to rounding.
  std::optional<HalfEdge> constrained_edge_at(TriangleId t, Point p) const;

  /// The sample nearest to `p`, if it has data, else `p`.
  Point snapped(Point p) const {
    const Sample s = space_.nearest(p);
    return std::isnan(space_.height(s)) ? p : space_.place(s);
  }

  /// `p` for a vertex between samples: where it is nearer than `part` of a cell to a column of
  /// samples, or a line of them, it is put there. Very near, rounding would decide on which side of
  /// its edges they are.
  Point clear_of_samples(Point p, double part) const;

  /// A sample on constrained edge `e` near `part` of its way, from 0 to 1, but in the middle of it.
  std::optional<Point> sample_inside(HalfEdge e, double part) const;

  /// Inserts a vertex at a sample that is in `t`, on a constrained edge of it if need be.
  /// \return false if that is not possible: a vertex is there, or the edge may not be cut
  /// \param changed  triangles with other corners are appended; rescan() is the caller's
  bool insert(TriangleId t, Sample s, std::vector<TriangleId>& changed);

  /// Inserts a vertex at `p`, in `t` and on no constrained edge, or returns false if one is there.
  bool insert_inside(TriangleId t, Point p, std::vector<TriangleId>& changed);
  /// Removes a vertex and looks at the samples of what changed, choose_diagonals() with `limit`
  /// included. The last vertex takes its place.
  /// \pre is_removable(removability(mesh(), v))
  Removal remove(VertexId v, double limit);

  /// Numbers the vertices from `first` on, and all triangles, along a Hilbert curve: work that goes
  /// from one to the next then finds its samples and triangles in the cache.
  /// \pre no input vertex has the number `first` or a higher one
  void renumber(std::size_t first);

  /// Gives vertices that the mesh has and heights() has not their heights.
  void add_heights();
  /// The same for a vertex that moved.
  void set_height(VertexId v) { state_.tin.heights[v.index()] = height_of(mesh().point(v)); }

 private:
  void scan_triangle(TriangleId t);
  bool choose_diagonal(HalfEdge e);
  bool is_on(HalfEdge e, Point p) const;
  bool cut_at(HalfEdge e, Point p, std::vector<TriangleId>& changed);

  const HeightGrid& grid_;
  SampleSpace space_;
  // How near to a line, in cells, a sample is on it: crossings of sides with lines of samples are
  // rounded, and twice as far stays clear of that.
  double on_line_;
  TriangleScan scan_;
  State state_;
  double enough_ = std::numeric_limits<double>::infinity();
  Cavity cavity_;
};

}  // namespace lepp
