// UGRID 1.0 in netCDF. The names are those that Deltares' D-Flow FM and MDAL look for.

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "lepp/geometry/error.hpp"
#include "lepp/io/atomic_files.hpp"
#include "lepp/io/classic_netcdf.hpp"
#include "lepp/io/crs_wkt.hpp"
#include "lepp/io/tin_files.hpp"
#include "lepp/triangulation/for_each_edge.hpp"

namespace lepp {

namespace {

using Attributes = std::vector<ClassicNetcdf::Attribute>;
using Numbers = ClassicNetcdf::Numbers;
using Type = ClassicNetcdf::Type;

constexpr std::int32_t first_number = 1;

std::int32_t number(VertexId v) { return static_cast<std::int32_t>(v.value) + first_number; }

std::vector<HalfEdge> edges(const Mesh& mesh) {
  std::vector<HalfEdge> list;
  for_each_edge(mesh, [&](HalfEdge e) { list.push_back(e); });
  return list;
}

class Ugrid {
 public:
  Ugrid(const WorldTin& tin) : tin_(tin), crs_(parse_crs_wkt(tin.crs)), edges_(edges(tin.mesh)) {
    nodes_dimension_ = file_.add_dimension("mesh2d_nNodes", tin.mesh.vertex_count());
    edges_dimension_ = file_.add_dimension("mesh2d_nEdges", edges_.size());
    faces_dimension_ = file_.add_dimension("mesh2d_nFaces", tin.mesh.triangle_count());
    corners_dimension_ = file_.add_dimension("mesh2d_nMax_face_nodes", 3);
    two_ = file_.add_dimension("Two", 2);
    file_.add_attribute({"Conventions", "CF-1.8 UGRID-1.0"});
    file_.add_attribute({"title", tin.title});
    add_topology();
    add_coordinates();
    add_connectivity();
    if (!tin.crs.empty()) add_crs();
  }

  const ClassicNetcdf& file() const { return file_; }

 private:
  std::string crs_name() const { return tin_.degrees ? "wgs84" : "projected_coordinate_system"; }

  void add_topology() {
    file_.add_variable({"mesh2d",
                        Type::integer,
                        {},
                        {{"cf_role", "mesh_topology"},
                         {"long_name", "topology of a triangulated terrain"},
                         {"topology_dimension", std::int32_t{2}},
                         {"node_dimension", "mesh2d_nNodes"},
                         {"edge_dimension", "mesh2d_nEdges"},
                         {"face_dimension", "mesh2d_nFaces"},
                         {"max_face_nodes_dimension", "mesh2d_nMax_face_nodes"},
                         {"node_coordinates", "mesh2d_node_x mesh2d_node_y"},
                         {"edge_node_connectivity", "mesh2d_edge_nodes"},
                         {"face_node_connectivity", "mesh2d_face_nodes"}},
                        [](Numbers& numbers) { numbers.put(std::int32_t{0}); }});
  }

  // value(i) at each vertex
  void add_at_nodes(std::string name, Attributes attributes, auto value) {
    if (!tin_.crs.empty()) attributes.push_back({"grid_mapping", crs_name()});
    const std::size_t n = tin_.mesh.vertex_count();
    file_.add_variable({std::move(name),
                        Type::real,
                        {nodes_dimension_},
                        std::move(attributes),
                        [n, value](Numbers& numbers) {
                          for (std::size_t i = 0; i < n; ++i) numbers.put(double{value(i)});
                        }});
  }

  void add_coordinates() {
    const WorldTin& tin = tin_;
    const std::optional<std::string> unit = name_of_unit(crs_.unit);
    const auto add = [&](const char* axis, const char* projected, const char* geographic,
                         const char* degrees, auto value) {
      Attributes attributes{{"standard_name", tin.degrees ? geographic : projected},
                            {"mesh", "mesh2d"},
                            {"location", "node"}};
      if (tin.degrees) attributes.push_back({"units", degrees});
      else if (unit) attributes.push_back({"units", *unit});
      add_at_nodes(axis, std::move(attributes), value);
    };
    add("mesh2d_node_x", "projection_x_coordinate", "longitude", "degrees_east",
        [&tin](std::size_t i) { return tin.mesh.points()[i].x; });
    add("mesh2d_node_y", "projection_y_coordinate", "latitude", "degrees_north",
        [&tin](std::size_t i) { return tin.mesh.points()[i].y; });
    add_heights();
  }

  void add_heights() {
    Attributes attributes{{"standard_name", "altitude"},
                          {"positive", "up"},
                          {"mesh", "mesh2d"},
                          {"location", "node"},
                          {"coordinates", "mesh2d_node_x mesh2d_node_y"}};
    if (const auto unit = name_of_unit(unit_of_heights())) attributes.push_back({"units", *unit});
    const WorldTin& tin = tin_;
    add_at_nodes("mesh2d_node_z", std::move(attributes),
                 [&tin](std::size_t i) { return tin.heights[i]; });
  }

  // Without a vertical system: the unit that cells have, too (HeightGrid::cell_width).
  std::optional<double> unit_of_heights() const {
    if (crs_.height_unit) return crs_.height_unit;
    return tin_.degrees ? 1 : crs_.unit;
  }

  void add_connectivity() {
    const auto& edge_list = edges_;
    const Mesh& mesh = tin_.mesh;
    file_.add_variable({"mesh2d_edge_nodes",
                        Type::integer,
                        {edges_dimension_, two_},
                        {{"cf_role", "edge_node_connectivity"}, {"start_index", first_number}},
                        [&](Numbers& numbers) {
                          for (const HalfEdge e : edge_list) {
                            numbers.put(number(mesh.origin(e)));
                            numbers.put(number(mesh.destination(e)));
                          }
                        }});
    file_.add_variable({"mesh2d_face_nodes",
                        Type::integer,
                        {faces_dimension_, corners_dimension_},
                        {{"cf_role", "face_node_connectivity"}, {"start_index", first_number}},
                        [&](Numbers& numbers) {
                          for (const Triangle& t : mesh.triangles()) {
                            for (const VertexId v : t.vertices) numbers.put(number(v));
                          }
                        }});
  }

  // CF and GDAL read crs_wkt and spatial_ref, D-Flow FM and MDAL epsg and wkt.
  void add_crs() {
    const std::string& wkt = tin_.crs;
    Attributes attributes{{"crs_wkt", wkt}, {"spatial_ref", wkt}, {"wkt", wkt}};
    if (tin_.degrees) attributes.push_back({"grid_mapping_name", "latitude_longitude"});
    const std::optional<std::int32_t> code = crs_.epsg;
    if (code) attributes.push_back({"epsg", *code});
    file_.add_variable(
        {crs_name(), Type::integer, {}, std::move(attributes), [code](Numbers& numbers) {
           numbers.put(code.value_or(0));
         }});
  }

  const WorldTin& tin_;
  const CrsWkt crs_;
  std::vector<HalfEdge> edges_;
  ClassicNetcdf file_;
  std::size_t nodes_dimension_ = 0, edges_dimension_ = 0, faces_dimension_ = 0,
              corners_dimension_ = 0, two_ = 0;
};

}  // namespace

void write_ugrid(const WorldTin& tin, const std::filesystem::path& path) {
  const Ugrid ugrid(tin);
  if (ugrid.file().largest_variable() >= std::numeric_limits<std::uint32_t>::max() - 4) {
    throw RefusedError(path.string(), "is too large for netCDF: a variable beyond 2^32 bytes",
                       "ask for a coarser mesh");
  }
  AtomicFiles files;
  ugrid.file().write(files.add(path));
  files.commit();
}

}  // namespace lepp
