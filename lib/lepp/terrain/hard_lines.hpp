#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lepp/terrain/height_grid.hpp"
#include "lepp/terrain/terrain_domain.hpp"
#include "lepp/terrain/tin.hpp"

namespace lepp {

// Lines that ask for heights. What is hard is known by segments of the mesh, which edges and the
// vertices on them belong to, never by coordinates: those are rounded where lines meet and in the
// world.

/// Lines as a triangulation; what crosses by rounding is cut there.
struct HardTriangulation {
  Mesh mesh;
  /// By point of the lines: its vertex, if it has one.
  std::vector<std::optional<VertexId>> vertex_of_point;
  std::vector<double> heights;      ///< by vertex: asked for by a line, or NaN
  std::vector<bool> hard_segments;  ///< by segment of the mesh; empty: none
};

/// \param fixed_heights  one per point, NaN: none; or empty
/// \param hard_segments  one per segment; or empty: none is
/// \pre   both ends of a hard segment have heights
/// \throw as constrained_delaunay()
HardTriangulation triangulate_lines(const Pslg& lines, const std::vector<double>& fixed_heights,
                                    const std::vector<bool>& hard_segments);

/// True if the height of each place on `e` is asked for.
bool is_hard(const Tin& tin, HalfEdge e);

/// The height that a vertex on a hard segment has there, from the heights of the segment's ends; of
/// others none, also of the ends. In any frame.
std::optional<double> height_on_hard_line(const Tin& tin, VertexId v);

/// By vertex: its height is asked for. Cost O(vertices + segments)
std::vector<bool> hard_vertices(const Tin& tin);

/// A sample with data on a hard line, and the height of the line above it.
struct HardSample {
  std::uint32_t column = 0, row = 0;  ///< row of the file
  double height = 0;
};

/// The samples that lie on hard lines, row by row, each once. Lines keep clear of others by a
/// hundredth of a cell (snap_lines.hpp), so what is nearer than rounding is on one.
/// \param tin  in grid space
/// Cost  O(triangles + cells that hard lines pass), nothing if there are none
std::vector<HardSample> samples_on_hard_lines(const HeightGrid& grid, const Tin& tin);

}  // namespace lepp
