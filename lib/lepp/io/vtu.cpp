#include "lepp/io/vtu.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <string_view>
#include <tuple>

#include "lepp/geometry/triangle_measures.hpp"
#include "lepp/io/atomic_files.hpp"
#include "lepp/io/xml_text.hpp"

namespace lepp {

namespace {

constexpr int vtk_triangle = 5, vtk_polygon = 7;

// The elements of one file, with one piece.
class Grid {
 public:
  Grid(OutputFile& out, std::size_t points, std::size_t cells) : out_(out) {
    out_ << "<?xml version=\"1.0\"?>\n"
         << "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
         << "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << points << "\" NumberOfCells=\""
         << cells << "\">\n";
  }

  void open(std::string_view element) { out_ << '<' << element << ">\n"; }
  void close(std::string_view element) { out_ << "</" << element << ">\n"; }

  // heights may be empty: all 0
  void points(std::span<const Point> points, std::span<const double> heights) {
    open("Points");
    out_ << "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
    for (std::size_t i = 0; i < points.size(); ++i) {
      out_ << points[i].x << ' ' << points[i].y << ' ' << (heights.empty() ? 0.0 : heights[i])
           << '\n';
    }
    close("DataArray");
    close("Points");
  }

  // value(i) for i = 0 .. n - 1
  void array(std::string_view type, std::string_view name, std::size_t n, auto value) {
    out_ << "<DataArray type=\"" << type << "\" Name=\"" << xml_text(name)
         << "\" format=\"ascii\">\n";
    for (std::size_t i = 0; i < n; ++i) out_ << value(i) << '\n';
    close("DataArray");
  }

  void values(const std::vector<NamedValues>& lists, [[maybe_unused]] std::size_t n) {
    for (const NamedValues& list : lists) {
      assert(list.values.size() == n);
      array("Float64", list.name, list.values.size(),
            [&](std::size_t i) { return list.values[i]; });
    }
  }

  void end() { out_ << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"; }

 private:
  OutputFile& out_;
};

int region_tag(const Mesh& mesh, SurfaceId s) {
  const auto& surfaces = mesh.entities().surfaces;
  return s.index() < surfaces.size() ? surfaces[s.index()].tag : static_cast<int>(s.value);
}

// Per triangle: 1 if no edge has a negative factor in the triangle's region.
std::vector<int> admissible_triangles(const Mesh& mesh) {
  using Key = std::tuple<VertexId, VertexId, SurfaceId>;
  std::vector<Key> offending;  // ascending
  for (const EdgeFactor& f : negative_edge_factors(mesh)) {
    offending.emplace_back(f.k, f.l, f.region);
  }
  std::vector<int> admissible(mesh.triangle_count(), 1);
  for (std::size_t i = 0; i < admissible.size(); ++i) {
    const TriangleId t(i);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({mesh.origin({t, k}), mesh.destination({t, k})});
      if (std::ranges::binary_search(offending, Key(low, high, mesh.region(t)))) admissible[i] = 0;
    }
  }
  return admissible;
}

void write_triangles(Grid& grid, const Mesh& mesh) {
  const std::size_t n = mesh.triangle_count();
  grid.open("Cells");
  grid.array("Int64", "connectivity", 3 * n,
             [&](std::size_t i) { return mesh.vertices(TriangleId(i / 3))[i % 3].value; });
  grid.array("Int64", "offsets", n, [](std::size_t i) { return 3 * (i + 1); });
  grid.array("UInt8", "types", n, [](std::size_t) { return vtk_triangle; });
  grid.close("Cells");
}

void write_triangle_data(Grid& grid, const Mesh& mesh, const VtuData& data) {
  const std::size_t n = mesh.triangle_count();
  const auto angles = [&](std::size_t i) {
    const auto [a, b, c] = mesh.corners(TriangleId(i));
    return angles_deg(a, b, c);
  };
  const std::vector<int> admissible = admissible_triangles(mesh);
  grid.open("CellData");
  grid.array("Int32", "region", n,
             [&](std::size_t i) { return region_tag(mesh, mesh.region(TriangleId(i))); });
  grid.array("Float64", "min_angle_deg", n,
             [&](std::size_t i) { return std::ranges::min(angles(i)); });
  grid.array("Float64", "max_angle_deg", n,
             [&](std::size_t i) { return std::ranges::max(angles(i)); });
  grid.array("UInt8", "admissible", n, [&](std::size_t i) { return admissible[i]; });
  grid.values(data.at_triangles, n);
  grid.close("CellData");
}

// Per piece the index of its box.
std::vector<std::size_t> box_of_piece(const VoronoiBoxes& boxes, std::size_t pieces) {
  std::vector<std::size_t> box_of(pieces, 0);
  for (std::size_t i = 0; i < boxes.boxes.size(); ++i) {
    const VoronoiBox& box = boxes.boxes[i];
    std::fill_n(box_of.begin() + box.first_piece, box.pieces, i);
  }
  return box_of;
}

}  // namespace

void write_vtu(const Mesh& mesh, const std::filesystem::path& path, const VtuData& data) {
  AtomicFiles files;
  Grid grid(files.add(path), mesh.vertex_count(), mesh.triangle_count());
  grid.points(mesh.points(), data.heights);
  write_triangles(grid, mesh);
  grid.open("PointData");
  grid.values(data.at_vertices, mesh.vertex_count());
  grid.close("PointData");
  write_triangle_data(grid, mesh, data);
  grid.end();
  files.commit();
}

void write_boxes_vtu(const Mesh& mesh, const VoronoiBoxes& boxes,
                     const std::filesystem::path& path) {
  const std::size_t pieces = boxes.piece_begin.empty() ? 0 : boxes.piece_begin.size() - 1;
  const std::vector<std::size_t> box_of = box_of_piece(boxes, pieces);
  const auto box = [&](std::size_t i) { return boxes.boxes[box_of[i]]; };
  AtomicFiles files;
  Grid grid(files.add(path), boxes.corners.size(), pieces);
  grid.points(boxes.corners, {});
  grid.open("Cells");
  grid.array("Int64", "connectivity", boxes.corners.size(), [](std::size_t i) { return i; });
  grid.array("Int64", "offsets", pieces, [&](std::size_t i) { return boxes.piece_begin[i + 1]; });
  grid.array("UInt8", "types", pieces, [](std::size_t) { return vtk_polygon; });
  grid.close("Cells");
  grid.open("CellData");
  grid.array("Int64", "vertex", pieces, [&](std::size_t i) { return box(i).vertex.value; });
  grid.array("Int32", "region", pieces,
             [&](std::size_t i) { return region_tag(mesh, box(i).region); });
  grid.array("Float64", "box_area", pieces, [&](std::size_t i) { return box(i).area; });
  grid.close("CellData");
  grid.end();
  files.commit();
}

}  // namespace lepp
