#include "lepp/io/gmsh_element_types.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "lepp/geometry/error.hpp"

namespace lepp {
namespace {

struct ElementType {
  int type;
  std::size_t nodes;
  const char* one;
  const char* many;
};

constexpr int line = 1, triangle = 2, point = 15;

constexpr std::array<ElementType, 27> types = {{
    {1, 2, "line", "lines"},
    {2, 3, "triangle", "triangles"},
    {3, 4, "quadrangle (4-node)", "quadrangles (4-node)"},
    {4, 4, "tetrahedron", "tetrahedra"},
    {5, 8, "hexahedron", "hexahedra"},
    {6, 6, "prism", "prisms"},
    {7, 5, "pyramid", "pyramids"},
    {8, 3, "second-order line (3-node)", "second-order lines (3-node)"},
    {9, 6, "second-order triangle (6-node)", "second-order triangles (6-node)"},
    {10, 9, "second-order quadrangle (9-node)", "second-order quadrangles (9-node)"},
    {11, 10, "second-order tetrahedron (10-node)", "second-order tetrahedra (10-node)"},
    {12, 27, "second-order hexahedron (27-node)", "second-order hexahedra (27-node)"},
    {13, 18, "second-order prism (18-node)", "second-order prisms (18-node)"},
    {14, 14, "second-order pyramid (14-node)", "second-order pyramids (14-node)"},
    {15, 1, "point", "points"},
    {16, 8, "second-order quadrangle (8-node)", "second-order quadrangles (8-node)"},
    {17, 20, "second-order hexahedron (20-node)", "second-order hexahedra (20-node)"},
    {18, 15, "second-order prism (15-node)", "second-order prisms (15-node)"},
    {19, 13, "second-order pyramid (13-node)", "second-order pyramids (13-node)"},
    {20, 9, "third-order triangle (9-node)", "third-order triangles (9-node)"},
    {21, 10, "third-order triangle (10-node)", "third-order triangles (10-node)"},
    {22, 12, "fourth-order triangle (12-node)", "fourth-order triangles (12-node)"},
    {23, 15, "fourth-order triangle (15-node)", "fourth-order triangles (15-node)"},
    {26, 4, "third-order line (4-node)", "third-order lines (4-node)"},
    {27, 5, "fourth-order line (5-node)", "fourth-order lines (5-node)"},
    {28, 6, "fifth-order line (6-node)", "fifth-order lines (6-node)"},
    {36, 16, "third-order quadrangle (16-node)", "third-order quadrangles (16-node)"},
}};

const ElementType* find(int type) {
  const auto found = std::find_if(types.begin(), types.end(),
                                  [type](const ElementType& known) { return known.type == type; });
  return found == types.end() ? nullptr : &*found;
}

std::string described(int type, std::uint64_t count) {
  const ElementType* known = find(type);
  if (known == nullptr) return fmt::format("{} elements of Gmsh type {}", count, type);
  return fmt::format("{} {}", count, count == 1 ? known->one : known->many);
}

}  // namespace

std::optional<std::size_t> nodes_of_gmsh_type(int type) {
  const ElementType* known = find(type);
  if (known == nullptr) return std::nullopt;
  return known->nodes;
}

void check_gmsh_elements(const GmshElementCounts& counts, const std::string& source) {
  std::string others, all;
  for (const auto& [type, count] : counts) {
    if (count == 0) continue;
    const std::string words = described(type, count);
    all += (all.empty() ? "" : ", ") + words;
    if (type != line && type != triangle && type != point)
      others += (others.empty() ? "" : ", ") + words;
  }
  if (all.empty())
    throw InputError(source, "there are no elements in the file",
                     "give a mesh of 3-node triangles");
  const auto triangles = counts.find(triangle);
  if (triangles == counts.end() || triangles->second == 0)
    throw InputError(source, "there are no 3-node triangles in the file (found " + all + ")",
                     "only meshes of 3-node triangles can be read");
  if (!others.empty())
    throw InputError(source, "it holds " + others, "only meshes of 3-node triangles can be read");
}

}  // namespace lepp
