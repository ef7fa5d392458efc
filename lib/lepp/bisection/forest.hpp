#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lepp/geometry/growing_array.hpp"
#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Which edge of a triangle is cut.
enum class BisectionRule {
  longest_edge,   ///< its longest, by edge_key: LEPP-bisection
  newest_vertex,  ///< the one opposite its newest vertex; the longest edge of a root
};

struct BisectOptions {
  /// New vertices on bent curves, of the boundary and between regions, lie on the curve, where that
  /// leaves all triangles counter-clockwise, and not halfway along the chord. Descendants then no
  /// longer fill their parent, and the bounds on angles hold only in the limit.
  bool follow_curves = false;
  unsigned threads = 2;  ///< at most so many; the result has the same bytes for any number
  /// No vertex is added beyond so many: what comes first in the order of work is cut, and the mesh
  /// conforms. 0: no limit.
  std::size_t max_vertices = 0;
};

/// A vertex between `a` and `b`: halfway, unless curves are followed. On the boundary it may be
/// some ulps away from there, so that the mesh does not reach over its boundary, exactly.
struct NewVertex {
  VertexId vertex, a, b;
};
/// One triangle and the two that fill it: one has its id, the other one has `other`.
struct Halves {
  TriangleId whole, other;
};

/// What bisect() did, in the order in which it was done: what was made may be cut again further
/// down the list. Neither list has anything that did not change.
struct Refinement {
  std::vector<NewVertex> vertices;  ///< their ids follow each other, from the old count on
  std::vector<Halves> triangles;    ///< ids `other` follow each other, from the old count on
  /// Marked, or on the way of those, and not cut: no double lies well between the ends of the edge.
  std::vector<TriangleId> refused;
  /// max_vertices came first: a marked triangle is as it was. `refused` then has those whose own
  /// edge is to blame, and not what waits for them.
  bool limited = false;
};

/// What coarsen() did, in the order in which it was done. With each removal the last vertex, or
/// triangle, takes the free id; triangles first: data[removed] = data[last], and one item less.
struct Coarsening {
  std::vector<NewVertex> vertices;  ///< `vertex` is removed, it lay between `a` and `b`
  std::vector<Halves> triangles;    ///< `other` is removed, `whole` is both again
};

using NodeId = Id<struct NodeOfForest>;  ///< a triangle of the trees, cut or not

/// A mesh that is refined by bisection and coarsened again, and the binary trees of its triangles:
/// the mesh at the start holds the roots, its triangles now are the leaves. The same triangles are
/// cut whatever the order of the marks: each is cut along its own edge or not at all.
///
///       c                   c
///      / \                / | \       the edge that is cut, a -> b, keeps its number in both
///     /   \     --->     /  |  \      halves; the first keeps the triangle's id and corner a,
///    a-----b            a---v---b     the second one keeps b
///
/// Keeps physical groups, segments and curve parameters. A call costs as much as what it changes.
/// Source [rivara1997] for the paths, [chen2010] for coarsening; docs/algorithms/bisection.md.
class Forest {
 public:
  /// Every triangle of `mesh` becomes a root. \pre M1 to M5
  explicit Forest(Mesh mesh, BisectionRule rule = BisectionRule::longest_edge);

  const Mesh& mesh() const { return mesh_; }
  Mesh take_mesh() && { return std::move(mesh_); }
  BisectionRule rule() const { return rule_; }

  /// Cuts each marked triangle once, and before it what must be cut so that the mesh conforms: the
  /// triangles of its LEPP. Ids of a triangle that is cut, and of all vertices, stay.
  /// \param marked  triangles of mesh(), in any order, perhaps repeatedly
  /// Cost  O(new triangles). Arrays grow twofold without being copied where the system can move
  ///       pages (growing_array.hpp); the table of constrained edges is copied when it doubles.
  /// \throw RefusedError beyond max_triangles (mesh.hpp), std::bad_alloc. Then a part of it is done
  ///        and the mesh conforms; what was marked may be marked again.
  Refinement bisect(std::span<const TriangleId> marked, const BisectOptions& options = {});
  /// The same for callers that go on after an exception: `done` then says what was done until
  /// there, so that values can be transferred. Its list of refused triangles need not be complete.
  void bisect(std::span<const TriangleId> marked, const BisectOptions& options, Refinement& done);

  /// Undoes the last cut of each marked triangle, where that leaves a conforming mesh: where a
  /// vertex has only marked triangles around it, all made when it was. Roots stay. Called with all
  /// triangles until nothing changes, it brings the mesh of the start back, every id included;
  /// only Mesh::leaving() of a vertex where parts of the domain touch may start another fan there.
  /// \param marked  triangles of mesh(), in any order, perhaps repeatedly
  /// \throw std::bad_alloc; nothing has changed then
  /// Cost  O(marked)
  Coarsening coarsen(std::span<const TriangleId> marked);

  std::size_t root_count() const { return roots_; }
  std::size_t root_vertex_count() const { return root_vertices_; }
  /// How often it was cut out of its root: 0 for a root.
  std::uint32_t generation(TriangleId t) const {
    return pairs_[leaves_[t.index()].node / 2].generation;
  }
  /// The triangle of the start that `t` lies in, by its id there. O(generation)
  TriangleId root(TriangleId t) const;
  /// The other half of the triangle that `t` is a half of, if that is a leaf; nothing for a root.
  std::optional<TriangleId> sibling(TriangleId t) const;
  /// The edge of `t` that will be cut.
  HalfEdge edge_to_cut(TriangleId t) const { return {t, leaves_[t.index()].cut}; }

  // The trees. A node, unlike a triangle, keeps its id for as long as it exists, whatever else is
  // cut or joined; coarsen() removes the two nodes that it joins, and their ids may come again.
  NodeId node(TriangleId t) const { return NodeId(leaves_[t.index()].node); }
  /// The triangle that `n` is if it is not cut.
  std::optional<TriangleId> triangle(NodeId n) const;
  /// What `n` is a half of; nothing for a root.
  std::optional<NodeId> parent(NodeId n) const;
  /// Its halves, the one that keeps its id in the mesh first; nothing if it is not cut.
  std::optional<std::array<NodeId, 2>> children(NodeId n) const;
  std::uint32_t generation(NodeId n) const { return pairs_[n.value / 2].generation; }
  /// Counter-clockwise, as the triangle had them before it was cut. O(generations below `n`)
  std::array<VertexId, 3> vertices(NodeId n) const;
  /// The triangles after at most `generation` cuts of each root: nodes of that generation, and
  /// leaves of lower ones, from the first root to the last, first halves first. They fill the
  /// domain, but need not conform. Levels that do follow from the order in which vertices were
  /// made: docs/algorithms/adaptive.md, Multigrid. O(nodes up to there)
  std::vector<NodeId> level(std::uint32_t generation) const;

 private:
  friend class Bisector;
  friend class Cutter;
  friend class Coarsener;
  static constexpr std::uint32_t none = 0xFFFFFFFFU;
  static constexpr std::uint8_t uncut = 3;
  // Nodes of the trees, by twos: half h of pair p is node 2 p + h. Root t is node t; what such a
  // pair says of a parent holds for both, as there is none.
  struct Pair {
    std::uint32_t parent = none;                    // the node whose halves they are
    std::array<std::uint32_t, 2> link{none, none};  // of each: its triangle, or its pair if cut
    std::uint16_t generation = 0;
    std::array<std::uint8_t, 2> cut{uncut, uncut};  // of each: the edge that was cut
  };
  enum class State : std::uint8_t { idle, listed, taken, waiting, refused };
  struct Leaf {
    std::uint32_t node = none;
    std::uint32_t announced = none;  // within a round, if it is cut: 4 * second half + edge
    std::uint8_t cut = 0;            // the edge that will be cut
    State state = State::idle;       // between two calls: idle
  };

  static bool is_first(std::uint32_t node) { return node % 2 == 0; }
  bool is_leaf(std::uint32_t node) const { return pairs_[node / 2].cut[node % 2] == uncut; }
  std::uint32_t parent(std::uint32_t node) const { return pairs_[node / 2].parent; }
  std::uint32_t link(std::uint32_t node) const { return pairs_[node / 2].link[node % 2]; }
  std::uint32_t& link(std::uint32_t node) { return pairs_[node / 2].link[node % 2]; }
  std::uint8_t& cut(std::uint32_t node) { return pairs_[node / 2].cut[node % 2]; }
  std::uint8_t cut(std::uint32_t node) const { return pairs_[node / 2].cut[node % 2]; }

  Mesh mesh_;
  BisectionRule rule_;
  std::size_t roots_, root_vertices_;
  GrowingArray<Pair> pairs_;               // those of the roots first
  std::vector<std::uint32_t> free_pairs_;  // unused
  GrowingArray<Leaf> leaves_;              // by triangle
};

}  // namespace lepp
