#include "inputs.hpp"

#include <set>
#include <system_error>

#include "lepp/io/file_kind.hpp"
#include "lepp/io/poly.hpp"
#include "validators.hpp"

namespace lepp::cli {

namespace {

void append(std::vector<std::string>& to, const std::vector<std::string>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

Pslg outline(const TriangleSoup& soup) {
  const Mesh mesh = mesh_from_triangles(soup).mesh;
  Pslg pslg;
  pslg.source = soup.source;
  pslg.base = soup.base;
  pslg.points.assign(mesh.points().begin(), mesh.points().end());
  pslg.segments.assign(mesh.segments().begin(), mesh.segments().end());
  pslg.entities = mesh.entities();
  // A segment without a curve gets one that says which surfaces lie on its two sides.
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const HalfEdge e{TriangleId(t), i};
      if (!mesh.separates_regions(e)) continue;
      Segment& segment = pslg.segments[mesh.segments_of(e)[0].index()];
      const int tag = segment.curve ? pslg.entities[*segment.curve].tag : 0;
      const auto groups =
          segment.curve ? pslg.entities[*segment.curve].groups : std::vector<GroupId>{};
      const auto across = mesh.twin(e);
      if (across && *across < e) continue;
      segment.curve = CurveId(pslg.entities.curves.size());
      CurveEntity curve{tag, groups, StraightCurve{}, {mesh.region(e.triangle)}};
      if (across) curve.bounds.push_back(mesh.region(across->triangle));
      pslg.entities.curves.push_back(std::move(curve));
    }
  }
  return pslg;
}

}  // namespace

Input read_input(const std::filesystem::path& path, const GmshOptions& options) {
  static const std::set<std::string> of_gmsh{".geo", ".msh", ".msh2", ".msh4", ".gmsh"};
  const std::string kind = file_kind(path);
  std::error_code error;  // a file that is not there is for the readers to report
  if (std::filesystem::is_directory(path, error)) {
    throw InputError(path.string(), "is a folder, not a file",
                     "give a .geo, .msh, .poly, .node or .ele file");
  }
  Input input;
  if (of_gmsh.contains(kind)) {
    GmshInput gmsh = read_gmsh(path, options);
    return {std::move(gmsh.pslg), std::move(gmsh.triangles), gmsh.pieces_have_sizes,
            std::move(gmsh.inner_sizes), std::move(gmsh.warnings)};
  }
  if (kind == ".poly" || kind == ".node") {
    input.pslg = read_poly(path);
  } else if (kind == ".ele") {
    input.triangles = read_ele(path);
    input.pslg = outline(*input.triangles);
  } else {
    throw InputError(path.string(), "is of no known kind ('" + kind + "')",
                     "give a .geo, .msh, .poly, .node or .ele file");
  }
  return input;
}

Triangulation read_mesh(const std::filesystem::path& path, std::vector<std::string>& warnings) {
  const Input input = read_input(path);
  append(warnings, input.warnings);
  if (!input.triangles) {
    throw InputError(path.string(), "holds geometry, not a mesh",
                     "make a mesh of it first: lepp mesh " + path.string() + " -o out.msh");
  }
  Triangulation result = mesh_from_triangles(*input.triangles);
  append(warnings, result.report.warnings);
  return result;
}

void add_gmsh_options(CLI::App& command, GmshOptions& options) {
  command
      .add_option("--chord-tolerance", options.chord_tolerance,
                  "curves: sagitta of a piece, as a share of the curve's bounding box")
      ->check(number_above_zero())
      ->capture_default_str();
  command.add_flag("--gmsh-sizes", options.gmsh_sizes,
                   "take the boundary points from Gmsh even if the .geo sets no sizes");
}

}  // namespace lepp::cli
