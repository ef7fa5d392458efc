#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

// Values of one mesh on another one of the same domain, however the other one was made: by
// refine(), from another size field, or read from a file. Both meshes are found in each other by
// walks; no mesh of intersections is made. The maps can be used for as many fields as there are; as
// sparse matrices: transfer_matrix.hpp. docs/algorithms/adaptive.md

/// P1: where each new vertex has its value from.
struct VertexTransfer {
  struct Source {
    std::array<VertexId, 3> corners;  ///< of an old triangle
    std::array<double, 3> weights;    ///< >= 0, their sum is 1
  };
  std::vector<Source> sources;      ///< one per new vertex
  std::size_t vertices_before = 0;  ///< how many there were
  std::size_t outside = 0;          ///< new vertices that no old triangle contains
};

/// Linear interpolation in the old triangle that contains the new vertex, or, where a curved
/// boundary has moved and none does, on the nearest place of the old boundary. That place is looked
/// for from where a walk leaves the old mesh: it is the nearest one wherever the new vertex is
/// closer to the boundary than the boundary is to other parts of itself.
///
/// Functions that are linear on the domain stay as they are, but for vertices outside; smooth ones
/// are met with order 2. Values stay between the smallest and the largest old one. A vertex that
/// both meshes have keeps its value exactly. At an interface, vertices have one value; none is
/// taken across it, unless the interface has moved.
/// \pre  M1 to M3, both with triangles
/// Cost  O(n) expected in the size of both meshes; and O(size of the old mesh) for each vertex of a
///       part of the new one, connected by edges, that has no vertex in the old mesh
VertexTransfer vertex_transfer(const Mesh& before, const Mesh& after);

/// \tparam Value  adds, and is multiplied by a double: a number, a Point, a fixed-size vector
/// \param  values one per old vertex; becomes one per new vertex
template <class Value>
void transfer_vertices(const VertexTransfer& transfer, std::vector<Value>& values) {
  std::vector<Value> found;
  found.reserve(transfer.sources.size());
  for (const auto& [corners, w] : transfer.sources) {
    const auto& [a, b, c] = corners;
    found.push_back(w[0] * values[a.index()] + w[1] * values[b.index()] + w[2] * values[c.index()]);
  }
  values.swap(found);
}

/// P1 that keeps the integral: the projection in L2. Of all functions that are linear on new
/// triangles it is the one nearest to the old one u, and its products with all of them are those of
/// u; with 1 it is the integral, kept to rounding (1e-12 of the integral of |u|) where both meshes
/// cover the same area. Order 2, linear functions stay; but where u has a kink that the new mesh
/// does not resolve, new values may be beyond the old ones. Where the old mesh is missing, what
/// vertex_transfer() gives is taken for u.
///
/// The mass matrix is solved with by conjugate gradients, in some 30 iterations on any mesh.
/// \param transfer  vertex_transfer(before, after)
/// \param values    one per old vertex; becomes one per new vertex
/// \pre   as for vertex_transfer().  Cost O(n) expected for each field
void project_vertices(const Mesh& before, const Mesh& after, const VertexTransfer& transfer,
                      std::vector<double>& values);

/// P0: which parts of old triangles each new one consists of.
struct TriangleTransfer {
  struct Share {
    TriangleId from;    ///< of the old mesh
    double weight = 0;  ///< of its density, > 0
  };
  std::vector<std::size_t> begins;   ///< by new triangle: its first share; and their number
  std::vector<Share> shares;         ///< new triangle by new triangle
  std::size_t triangles_before = 0;  ///< how many there were

  std::span<const Share> of(TriangleId t) const {
    return std::span(shares).subspan(begins[t.index()], begins[t.index() + 1] - begins[t.index()]);
  }
};

struct TriangleTransferOptions {
  /// Where the meshes do not cover the same area, as at curved boundaries of which one mesh has
  /// shorter chords, a density cannot keep both its integral and its value.
  enum class Keep {
    integrals,  ///< what an old triangle has is handed on in full, on as much area as there is now
    values,     ///< constants, and the bounds of the values; integrals change as the area does
  };
  Keep keep = Keep::integrals;
  /// Nothing is handed on from one region to another: integrals are kept in each. The regions of
  /// both meshes must be the same; false: all are taken for one.
  bool by_region = true;
};

/// The mean over each new triangle of the function that is constant on old ones: the projection in
/// L2, of order 1. Each old triangle is cut by the new ones that it meets, which a walk finds.
///
/// The integral over the domain, and over each region, is kept to rounding (1e-12 of the integral
/// of the absolute value). What follows holds to the rounding of areas, which in slivers no higher
/// than some ulps of their coordinates is as large as the areas are. Where both meshes cover the same area, constants stay, and new values
/// lie between the smallest and the largest old one. Elsewhere a new triangle that is partly
/// outside the old mesh takes the mean over what is inside, one fully outside takes that of the
/// nearest one that is not, counted in triangles, and what old triangles have is then divided among
/// those that take from them in proportion.
///
/// So a piece that one mesh lacks, as where a boundary has moved, is filled from beside it, however
/// large it is, and nobody is told; only a whole connected part without any counterpart is an
/// error. Where a new triangle meets the old mesh in several parts, cut off from each other by a
/// boundary that has moved, parts without the middle of the triangle may be missed.
/// \pre   M1 to M3, both with triangles
/// \throw InputError if a connected part of the domain, or of a region, is in one mesh only
/// Cost   O(n) expected in the size of both meshes and the number of pairs that overlap
TriangleTransfer triangle_transfer(const Mesh& before, const Mesh& after,
                                   const TriangleTransferOptions& options = {});

/// \param densities  one per old triangle; becomes one per new triangle. Amounts are densities
///                   times areas
void transfer_triangles(const TriangleTransfer& transfer, std::vector<double>& densities);

}  // namespace lepp
