#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "fuzz/target.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/io/poly.hpp"
#include "lepp/triangulation/validate.hpp"
#include "support/invariants.hpp"

namespace lepp::test {

namespace {

namespace fs = std::filesystem;

// A folder of this process, in memory where the system has that.
const fs::path& folder() {
  static const struct Folder {
    fs::path path;
    Folder() {
      const fs::path base = fs::is_directory("/dev/shm") ? "/dev/shm" : fs::temp_directory_path();
      path = base / ("lepp_fuzz_" + std::to_string(getpid()));
      fs::create_directories(path);
    }
    ~Folder() {
      std::error_code ignored;
      fs::remove_all(path, ignored);
    }
  } one;
  return one.path;
}

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// What was read and written reads back as the same, and writes the same bytes again.
void check_round_trip(const Pslg& pslg) {
  const fs::path first = folder() / "first.poly", second = folder() / "second.poly";
  write_poly(pslg, first);
  const Pslg again = read_poly(first);
  if (again.points != pslg.points) fail("points changed on the way");
  if (again.segments.size() != pslg.segments.size()) fail("segments were lost on the way");
  if (again.holes != pslg.holes || again.seeds.size() != pslg.seeds.size()) {
    fail("holes or regions were lost on the way");
  }
  write_poly(again, second);
  if (text_of(first) != text_of(second)) fail("writing again gives other bytes");
}

void check_mesh(const Pslg& pslg, Crossings crossings) {
  try {
    const Triangulation result = constrained_delaunay(pslg, {.crossings = crossings});
    if (const auto broken = broken_topology(result.mesh)) fail(broken->c_str());
    if (const auto broken = broken_delaunay(result.mesh)) fail(broken->c_str());
    const fs::path path = folder() / "mesh.ele";
    write_ele(result.mesh, path);
    const Mesh again = mesh_from_triangles(read_ele(path)).mesh;
    if (again.triangle_count() != result.mesh.triangle_count()) fail("the .ele lost triangles");
    if (!validate(again).valid()) fail("the mesh is not valid when read again");
  } catch (const InputError&) {  // which errors are right, pslg_to_cdt asks
  }
}

}  // namespace

void fuzz_poly_reader(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t max_bytes = 4096, max_items = 200;
  if (bytes.size() > max_bytes) return;
  const fs::path path = folder() / "input.poly";
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  Pslg pslg;
  try {
    pslg = read_poly(path);
  } catch (const InputError& error) {
    if (error.where().empty() || error.problem().empty()) fail("an error that does not say where");
    return;
  } catch (const RefusedError&) {
    return;
  }
  if (pslg.points.size() > max_items || pslg.segments.size() > max_items) return;
  check_round_trip(pslg);
  check_mesh(pslg, Crossings::refuse);
  check_mesh(pslg, Crossings::split);
}

}  // namespace lepp::test
