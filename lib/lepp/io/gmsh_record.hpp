#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lepp/geometry/curve.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/geometry/point.hpp"

namespace lepp {

/// What the helper lepp-gmsh sends back about one file, in Gmsh's own terms: entities are known by
/// dimension and tag, coordinates have a z. Nothing here depends on the Gmsh SDK.

struct GmshGroup {
  int dimension = 0;
  int tag = 0;
  std::string name;
};

struct GmshPoint {
  int tag = 0;
  Point position;
  double z = 0;
  std::vector<int> groups;
};

/// A curve, with parameters scaled to [0, 1].
struct GmshCurve {
  int tag = 0;
  int begin = 0, end = 0;  ///< tags of its end points, equal on a closed curve
  std::vector<int> groups;
  Curve geometry;
  double z_low = 0, z_high = 0;
  double length = 0;
  std::vector<CurvePoint> inner;  ///< Gmsh's own points between the ends, by parameter
};

struct GmshSurface {
  int tag = 0;
  std::vector<int> groups;
  std::vector<int> boundary;  ///< curve tags, once per occurrence
  std::vector<int> embedded_points, embedded_curves;
  double z_low = 0, z_high = 0;  ///< over samples of the surface itself
};

struct GmshTriangle {
  std::int64_t tag = 0;                  ///< of the element, as in the next two
  std::array<std::uint32_t, 3> nodes{};  ///< indices into GmshMesh::node_tags
  int surface = 0;
};

struct GmshLine {
  std::int64_t tag = 0;
  std::array<std::uint32_t, 2> nodes{};
  int curve = 0;
};

struct GmshNodeOfPoint {
  std::int64_t tag = 0;  ///< of the element
  std::uint32_t node = 0;
  int point = 0;
};

/// A size that Gmsh wants at a point that ends no curve.
struct GmshSizeAt {
  Point position;
  double size = 0;
};

/// The elements of a .msh file. Curves and surfaces above carry its groups, not its shapes.
struct GmshMesh {
  std::vector<std::int64_t> node_tags;
  std::vector<double> coordinates;  ///< x y z, x y z, ...
  std::vector<GmshTriangle> triangles;
  std::vector<GmshLine> lines;
  std::vector<GmshNodeOfPoint> points;
};

/// Why there is nothing else in the record.
struct GmshFailure {
  ErrorKind kind = ErrorKind::input;
  std::string where;  ///< appended to the file's name; may be empty
  std::string problem, remedy;
};

struct GmshRecord {
  std::optional<GmshFailure> failure;
  std::vector<std::string> warnings;
  std::vector<GmshGroup> groups;
  std::vector<GmshPoint> points;
  std::vector<GmshCurve> curves;
  std::vector<GmshSurface> surfaces;
  std::optional<GmshMesh> mesh;         ///< for .msh files
  bool own_points = false;              ///< GmshCurve::inner is filled
  std::optional<double> largest_size;   ///< Mesh.MeshSizeMax, with the factor for all sizes
  std::vector<GmshSizeAt> inner_sizes;  ///< at points embedded in surfaces
};

/// One record as bytes: magic, version, payload length, payload, checksum.
std::vector<std::byte> encode(const GmshRecord& record);

/// \return  the record, or nothing if the bytes are not one complete, undamaged record; counts are
///          checked against the bytes that are left before anything is allocated
std::optional<GmshRecord> decode_gmsh_record(std::span<const std::byte> bytes);

}  // namespace lepp
