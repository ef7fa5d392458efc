// hashes FOLDER POLY...  prints a hash of each file that meshing leads to; FOLDER is for the files.

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

#include "bench/families.hpp"
#include "lepp/io/msh.hpp"
#include "lepp/io/poly.hpp"
#include "lepp/io/text_file.hpp"
#include "lepp/refine/refine.hpp"
#include "lepp/triangulation/constrained_delaunay.hpp"

namespace {

using namespace lepp;
namespace fs = std::filesystem;

// FNV-1a, 64 bits.
std::uint64_t hash_of(std::string_view bytes) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  return hash;
}

void print_hash(const std::string& name, const fs::path& file) {
  const std::uint64_t hash = hash_of(read_text_file(file).text);
  std::printf("%s %s %016llx\n", name.c_str(), file.filename().c_str(),
              static_cast<unsigned long long>(hash));
}

void print_mesh(const std::string& name, const Mesh& mesh, const fs::path& folder) {
  write_ele(mesh, folder / "mesh.ele");
  for (const char* file : {"mesh.node", "mesh.ele", "mesh.poly"}) print_hash(name, folder / file);
  write_msh(mesh, folder / "mesh.msh");
  print_hash(name, folder / "mesh.msh");
}

// The input goes through a file, so that a generator that differs is told from a mesher that does.
void mesh(const std::string& name, const fs::path& poly, const fs::path& folder) {
  print_hash(name + " input", poly);
  Pslg pslg = read_poly(poly);
  pslg.source = name;
  Mesh mesh = constrained_delaunay(pslg, {Crossings::split}).mesh;
  print_mesh(name + " plain", mesh, folder);
  RefineOptions options;
  options.min_angle_deg = 30;
  options.obtuse = ObtuseRule::split_first;
  options.max_vertices = 3000;
  const RefineReport report = refine(mesh, options);
  std::printf("%s refined: %zu Steiner points\n", name.c_str(), report.steiner_points);
  print_mesh(name + " refined", mesh, folder);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const fs::path folder = argv[1];
    fs::create_directories(folder);
    const fs::path poly = folder / "input.poly";
    for (const test::Family& family : test::families()) {
      for (const std::size_t points : {64U, 400U}) {
        for (const std::uint64_t seed : {1U, 2U}) {
          write_poly(family.make(points, seed), poly);
          std::string name = family.name;
          name.append(" ").append(std::to_string(points)).append(" ").append(std::to_string(seed));
          mesh(name, poly, folder);
        }
      }
    }
    // Far from the origin, where coordinates are coarse, and with a crossing in every other row.
    for (const std::uint64_t seed : {3U, 4U}) {
      Pslg pslg = test::families()[0].make(200, seed);
      for (Point& p : pslg.points) p = {p.x + 1e7, p.y - 1e7};
      for (std::uint32_t i = 4; i < 24; i += 2) {
        pslg.segments.push_back({VertexId(i), VertexId(i + 1), std::nullopt, 0, 1});
      }
      write_poly(pslg, poly);
      mesh("crossings " + std::to_string(seed), poly, folder);
    }
    for (int i = 2; i < argc; ++i) mesh(fs::path(argv[i]).filename().string(), argv[i], folder);
  } catch (const std::exception& error) {
    std::printf("error: %s\n", error.what());
    return 1;
  }
  return 0;
}
