// Formats of hydrodynamic solvers that are text: ADCIRC / SCHISM, SMS.

#include "lepp/io/atomic_files.hpp"
#include "lepp/io/boundary_loops.hpp"
#include "lepp/io/tin_files.hpp"

namespace lepp {

namespace {

std::size_t number(VertexId v) { return v.index() + 1; }

bool is_outer(const BoundaryLoop& loop) { return loop.area > 0; }

// Where a boundary list ends: an outer loop with its first node again.
std::size_t nodes_listed(const BoundaryLoop& loop) {
  return loop.sides.size() + (is_outer(loop) ? 1 : 0);
}

void write_land_boundaries(OutputFile& out, const Mesh& mesh) {
  const std::vector<BoundaryLoop> loops = simple_boundary_loops(mesh);
  std::size_t all = 0;
  for (const BoundaryLoop& loop : loops) all += nodes_listed(loop);
  out << "0 = number of open boundaries\n0 = total number of open boundary nodes\n"
      << loops.size() << " = number of land boundaries\n"
      << all << " = total number of land boundary nodes\n";
  std::size_t i = 0;
  for (const BoundaryLoop& loop : loops) {
    out << nodes_listed(loop) << ' ' << (is_outer(loop) ? 0 : 1)
        << " = number of nodes and type of land boundary " << ++i << '\n';
    for (const HalfEdge e : loop.sides) out << number(mesh.origin(e)) << '\n';
    if (is_outer(loop)) out << number(mesh.origin(loop.sides.front())) << '\n';
  }
}

int material(const Mesh& mesh, SurfaceId region) {
  const auto& surfaces = mesh.entities().surfaces;
  const int tag = region.index() < surfaces.size() ? surfaces[region.index()].tag : 1;
  return tag > 0 ? tag : 1;
}

void write_corners(OutputFile& out, const std::array<VertexId, 3>& corners) {
  for (const VertexId v : corners) out << ' ' << number(v);
}

}  // namespace

void write_adcirc(const WorldTin& tin, const std::filesystem::path& path) {
  AtomicFiles files;
  OutputFile& out = files.add(path);
  out << tin.title << '\n' << tin.mesh.triangle_count() << ' ' << tin.mesh.vertex_count() << '\n';
  for (std::size_t i = 0; i < tin.mesh.vertex_count(); ++i) {
    const Point p = tin.mesh.point(VertexId(i));
    out << i + 1 << ' ' << p.x << ' ' << p.y << ' ' << 0.0 - tin.heights[i] << '\n';  // no -0
  }
  for (std::size_t i = 0; i < tin.mesh.triangle_count(); ++i) {
    out << i + 1 << " 3";
    write_corners(out, tin.mesh.vertices(TriangleId(i)));
    out << '\n';
  }
  write_land_boundaries(out, tin.mesh);
  files.commit();
}

void write_2dm(const WorldTin& tin, const std::filesystem::path& path) {
  AtomicFiles files;
  OutputFile& out = files.add(path);
  out << "MESH2D\n";
  for (std::size_t i = 0; i < tin.mesh.triangle_count(); ++i) {
    out << "E3T " << i + 1;
    write_corners(out, tin.mesh.vertices(TriangleId(i)));
    out << ' ' << material(tin.mesh, tin.mesh.region(TriangleId(i))) << '\n';
  }
  for (std::size_t i = 0; i < tin.mesh.vertex_count(); ++i) {
    const Point p = tin.mesh.point(VertexId(i));
    out << "ND " << i + 1 << ' ' << p.x << ' ' << p.y << ' ' << tin.heights[i] << '\n';
  }
  files.commit();
}

}  // namespace lepp
