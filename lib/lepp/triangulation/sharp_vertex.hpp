#pragma once

#include <cstdint>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// A sharp vertex is one where consecutive constrained edges meet, through the domain, at less than
/// 60 degrees. Rules for them, after the concentric shells of Ruppert and the seditious edges of
/// Miller, Pav and Walkington: docs/algorithms/sharp_vertices.md.

/// The fan of a constrained edge at one of its ends: all constrained edges linked to it through
/// wedges below 60 degrees, each one seen from some side. (Below 45 degrees edges encroach each
/// other; up to 60 unequal radii can still make ever smaller triangles between them.)
struct Fan {
  VertexId center;
  std::vector<HalfEdge> edges;  ///< at least two if it is a fan, `edge` among them; else empty
  bool exists() const { return !edges.empty(); }
};

/// True if two distances from `center` differ by no more than 1e-9 of them, or than rounding of
/// coordinates does, which is more where those are large: fans cut at a common radius have edges of
/// the same length, rounded.
bool is_same_radius(double r, double s, Point center);

/// \param edge    a constrained edge, seen from either side
/// \param center  one of its ends
/// Cost O(degree of center)
Fan fan_at(const Mesh& mesh, HalfEdge edge, VertexId center);

/// For each triangle a bit per corner: set if the corner lies in a wedge of constrained edges below
/// 60 degrees. Cost O(triangles), however many meet at one vertex.
std::vector<std::uint8_t> corners_in_sharp_wedges(const Mesh& mesh);

/// The corner of `t` with the smallest angle, the one opposite its shortest edge.
std::uint32_t smallest_corner(const Mesh& mesh, TriangleId t);

/// True if both sides of the smallest angle of `t` are constrained: no insertion can change it.
bool smallest_angle_between_constrained(const Mesh& mesh, TriangleId t);

/// True if the shortest edge of `t` is seditious: it joins points on two input segments that meet
/// below 60 degrees at a vertex equally far from both. Splitting it off would only repeat the
/// picture at half the scale.
bool shortest_edge_is_seditious(const Mesh& mesh, TriangleId t);

/// True if two input segments may meet below 60 degrees somewhere; if not, no edge is seditious.
/// Where many meet at a vertex it does not look closer. Cost O(segments)
bool segments_meet_sharply(const Mesh& mesh);

/// True if the input itself has two separate features closer than `floor` at `t`: a vertex of the
/// input and another point of the input, or such a point and a segment, where no segment of one is
/// or touches a segment of the other.
bool at_input_feature(const Mesh& mesh, TriangleId t, double floor);

}  // namespace lepp
