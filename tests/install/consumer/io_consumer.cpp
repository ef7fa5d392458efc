// io_consumer FILE.geo HELPER FOLDER: geometry through the installed helper, a mesh through files
// and back. Exit status 0 if all facts hold.

#include <cstdio>
#include <filesystem>

#include "lepp/geometry/error.hpp"
#include "lepp/io/gmsh_import.hpp"
#include "lepp/io/msh.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"

using namespace lepp;

int main(int count, char** arguments) {
  if (count != 4) return 2;
  const std::filesystem::path folder = arguments[3];
  try {
    const GmshOptions options{.helper = arguments[2]};
    const Mesh mesh = constrained_delaunay(read_geo(arguments[1], options)).mesh;
    write_msh(mesh, folder / "io_consumer.msh");
    const auto again = read_gmsh(folder / "io_consumer.msh", options).triangles;
    if (again && again->triangles.size() == mesh.triangle_count()) return 0;
    std::fputs("the mesh read back is not the mesh written\n", stderr);
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  return 1;
}
