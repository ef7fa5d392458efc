#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lepp/bisection/forest.hpp"

namespace lepp {

/// An edge that will be cut with the triangles on its sides, in rounds: all cuts are planned, then
/// all get their ids, then all are written. Each step may be done for different cuts at the same
/// time, as long as no triangle has two of them.
struct Cut {
  struct Side {
    HalfEdge e;            ///< the edge as its triangle sees it
    TriangleId second;     ///< the half that gets a new id
    std::uint32_t pair;    ///< the nodes of both halves
    std::uint8_t next[2];  ///< of each half the edge to be cut one day
  };
  std::array<Side, 2> sides;
  std::uint8_t side_count = 1;
  bool constrained = false;
  VertexId vertex;
  Point middle;
  double parameter = 0;  ///< of a constrained edge, at the middle

  std::span<Side> both() { return {sides.data(), side_count}; }
  std::span<const Side> both() const { return {sides.data(), side_count}; }
};

/// Cuts edges of a forest and grows its trees.
class Cutter {
 public:
  Cutter(Forest& forest, const BisectOptions& options)
      : forest_(forest), mesh_(forest.mesh_), options_(options) {}

  /// Where `e` will be cut, in the middle or, on the boundary, some ulps inside of it, its twin
  /// being `across`; nothing if no double lies well between.
  std::optional<Cut> plan(HalfEdge e, std::optional<HalfEdge> across) const;
  /// Tells those who look across its edges that the triangles of the cut will be cut.
  void announce(const Cut& cut);
  /// Writes the triangles of the cut, what is across their edges if that is not cut, the points
  /// that these triangles alone know, and the trees. Lists the triangles that waited for them.
  /// \pre    all cuts of the round are announced, and there is room for what is new
  /// \param  woken  gets those that are listed now
  void write(const Cut& cut, std::vector<TriangleId>& woken);
  /// The round is over for the triangles of the cut.
  void forget(const Cut& cut);

  // Meshes are larger than the cache, and neighbours do not lie beside each other in memory. So
  // what will be looked at soon is asked for, while other work goes on.
  void prefetch(TriangleId t) const;
  /// What plan() needs for the triangles of `list` some places after `i`.
  void prefetch_for_plans(std::span<const TriangleId> list, std::size_t i) const;
  /// What write() needs for the cuts some places after `i`.
  void prefetch_for_writes(std::span<const Cut> cuts, std::size_t i) const;

 private:
  bool place_middle(Cut& cut) const;
  bool try_middle(Cut& cut, Point middle) const;
  void write_side(const Cut& cut, const Cut::Side& side, std::optional<HalfEdge> beside_a,
                  std::optional<HalfEdge> beside_b);
  void wake(std::optional<HalfEdge> across, std::vector<TriangleId>& woken);
  std::optional<HalfEdge> now_across(HalfEdge e) const;
  void grow_tree(const Cut::Side& side);

  std::optional<HalfEdge> across_cut(TriangleId t) const {
    return mesh_.twin(forest_.edge_to_cut(t));
  }
  std::uint32_t& announced(TriangleId t) { return forest_.leaves_[t.index()].announced; }
  std::uint32_t announced(TriangleId t) const { return forest_.leaves_[t.index()].announced; }

  Forest& forest_;
  Mesh& mesh_;
  const BisectOptions& options_;
};

}  // namespace lepp
