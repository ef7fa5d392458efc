#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace lepp {

/// A 32-bit index that knows what it counts. Absence is std::optional, never a special value.
template <class What>
struct Id {
  std::uint32_t value = 0;

  constexpr Id() = default;
  constexpr explicit Id(std::uint32_t index) : value(index) {}
  constexpr explicit Id(std::size_t index) : value(static_cast<std::uint32_t>(index)) {}
  constexpr std::size_t index() const { return value; }
  friend constexpr auto operator<=>(Id, Id) = default;
};

using VertexId = Id<struct VertexOfMesh>;      ///< index into Mesh::points, or Pslg::points
using TriangleId = Id<struct TriangleOfMesh>;  ///< index into Mesh::triangles
using SegmentId = Id<struct SegmentOfPslg>;    ///< index into Pslg::segments, Mesh::segments
using GroupId = Id<struct GroupOfEntities>;    ///< index into Entities::groups
using PointEntityId = Id<struct PointEntityOfEntities>;  ///< index into Entities::points
using CurveId = Id<struct CurveOfEntities>;              ///< index into Entities::curves
using SurfaceId = Id<struct SurfaceOfEntities>;  ///< index into Entities::surfaces: a region

}  // namespace lepp

template <class What>
struct std::hash<lepp::Id<What>> {
  std::size_t operator()(lepp::Id<What> id) const noexcept { return id.value; }
};
