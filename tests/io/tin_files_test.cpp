#include "lepp/io/tin_files.hpp"

#include <doctest/doctest.h>

#include "io/scratch_folder.hpp"
#include "io/small_tins.hpp"
#include "lepp/geometry/error.hpp"
#include "lepp/io/poly.hpp"
#include "support/hand_made.hpp"

using namespace lepp;
using test::Bytes;
using test::contains;
using test::error_of;
using test::ring;
using test::ScratchFolder;
using test::small_tin;
using test::utm;

TEST_CASE("OBJ: vertices and triangles as text") {
  const ScratchFolder folder;
  write_obj(small_tin(), folder / "a.obj");
  CHECK(folder.text("a.obj") ==
        "# small\nv 0 0 0\nv 1 0 1.5\nv 1 1 -2\nv 0 1 0.1\nf 1 2 3\nf 1 3 4\n");
}

TEST_CASE("PLY: doubles, little-endian") {
  const ScratchFolder folder;
  write_ply(small_tin(), folder / "a.ply");
  const std::string text = folder.text("a.ply");
  const std::string end = "end_header\n";
  CHECK(
      text.starts_with("ply\nformat binary_little_endian 1.0\ncomment small\nelement vertex 4\n"));
  Bytes bytes(text.substr(text.find(end) + end.size()), std::endian::little);
  for (const double wanted : {0., 0., 0., 1., 0., 1.5, 1., 1., -2., 0., 1., 0.1}) {
    CHECK(bytes.next<double>() == wanted);
  }
  for (const std::array<int, 3> wanted : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
    CHECK(bytes.next<std::uint8_t>() == 3);
    for (const int v : wanted) CHECK(bytes.next<std::int32_t>() == v);
  }
  CHECK(bytes.at_end());
}

TEST_CASE("STL near the origin keeps its coordinates") {
  const ScratchFolder folder;
  write_stl(small_tin(), folder / "a.stl");
  Bytes bytes(folder.text("a.stl"), std::endian::little);
  CHECK(bytes.text(80).starts_with("lepp TIN; small "));
  CHECK(bytes.next<std::uint32_t>() == 2);
  const float nx = bytes.next<float>(), ny = bytes.next<float>(), nz = bytes.next<float>();
  CHECK(nx * nx + ny * ny + nz * nz == doctest::Approx(1));
  CHECK(nx * 1 + nz * 1.5 == doctest::Approx(0));  // at right angles to the edge 0-1
  CHECK(nz > 0);
  for (const float wanted : {0.f, 0.f, 0.f, 1.f, 0.f, 1.5f, 1.f, 1.f, -2.f}) {
    CHECK(bytes.next<float>() == wanted);
  }
  CHECK(bytes.next<std::uint16_t>() == 0);
}

TEST_CASE("STL far from the origin is written relative to a corner that its header names") {
  const ScratchFolder folder;
  const WorldTin far = ring({500000.25, 4100000.75});
  CHECK(offset_of_float_files(far) == Point{500000, 4100000});
  CHECK(offset_of_float_files(ring()) == Point{0, 0});
  write_stl(far, folder / "a.stl");
  const std::string text = folder.text("a.stl");
  CHECK(contains(text, "add 500000 to x, 4100000 to y"));
  CHECK(text.size() == 84 + 8 * 50);
  Bytes bytes(text, std::endian::little);
  bytes.go_to(84 + 12);
  CHECK(bytes.next<float>() == 0.25f);
  CHECK(bytes.next<float>() == 0.75f);
}

TEST_CASE("offsets of float files have the digits that a grid in degrees needs") {
  WorldTin tin = small_tin();
  const auto at = [&](Point corner, double size) {
    tin.mesh = test::two_triangles(corner, {corner.x + size, corner.y},
                                   {corner.x + size, corner.y + size}, {corner.x, corner.y + size});
    return offset_of_float_files(tin);
  };
  CHECK(at({-117.123456, 36.98765}, 0.02) == Point{-117.13, 36.98});
  CHECK(rounding_of_float_file(tin, OffsetDigits::decimal) < 0.02 * 0x1p-23);
  CHECK(rounding_of_float_file(tin, OffsetDigits::whole) > 0.02 * 0x1p-23);
  CHECK(at({-117.123456, 36.98765}, 25) == Point{-118, 36});
  CHECK(at({0.5, 0.5}, 25) == Point{0, 0});
  CHECK(at({-117.123456, 36.98765}, 0.5) == Point{-117.2, 36.9});
  CHECK(offset_of_float_files(tin, OffsetDigits::whole) == Point{-118, 36});
  const ScratchFolder folder;
  write_stl(tin, folder / "a.stl");
  CHECK(contains(folder.text("a.stl"), "add -117.2 to x, 36.9 to y"));
}

TEST_CASE("STL refuses triangles that its floats cannot hold") {
  const ScratchFolder folder;
  WorldTin tin = small_tin();
  tin.mesh = test::two_triangles({0, 0}, {1e8, 0}, {1e8, 1e8}, {1e8 - 1, 1e8});
  try {
    write_stl(tin, folder / "a.stl");
    FAIL("accepted");
  } catch (const InputError& error) {
    CHECK(contains(error.problem(), "32-bit"));
  }
  CHECK_FALSE(std::filesystem::exists(folder / "a.stl"));
}

TEST_CASE("ADCIRC: depths are positive down, the outer loop is closed, the island is clockwise") {
  const ScratchFolder folder;
  write_adcirc(small_tin(), folder / "a.14");
  CHECK(folder.text("a.14") ==
        "small\n2 4\n1 0 0 0\n2 1 0 -1.5\n3 1 1 2\n4 0 1 -0.1\n1 3 1 2 3\n2 3 1 3 4\n"
        "0 = number of open boundaries\n0 = total number of open boundary nodes\n"
        "1 = number of land boundaries\n5 = total number of land boundary nodes\n"
        "5 0 = number of nodes and type of land boundary 1\n2\n3\n4\n1\n2\n");
  write_adcirc(ring(), folder / "b.gr3");
  const std::string text = folder.text("b.gr3");
  CHECK(contains(text, "2 = number of land boundaries\n9 = total"));
  CHECK(contains(text, "5 0 = number of nodes and type of land boundary 1\n1\n2\n3\n4\n1\n"));
  CHECK(contains(text, "4 1 = number of nodes and type of land boundary 2\n6\n5\n8\n7\n"));
}

TEST_CASE("ADCIRC: where parts touch, each loop passes a node once") {
  const ScratchFolder folder;
  WorldTin tin = small_tin();
  // Two triangles that touch in node 3.
  const std::vector<Point> points = {{0, 2}, {0, 1}, {1, 1}, {1, 0}, {2, 0}};
  tin.mesh = test::from_triangles(points, {{0, 1, 2}, {3, 4, 2}});
  tin.heights.assign(5, 0);
  write_adcirc(tin, folder / "a.14");
  const std::string parts = folder.text("a.14");
  CHECK(contains(parts, "2 = number of land boundaries\n8 = total"));
  CHECK(contains(parts, "4 0 = number of nodes and type of land boundary 1\n3\n4\n5\n3\n"));
  CHECK(contains(parts, "4 0 = number of nodes and type of land boundary 2\n2\n3\n1\n2\n"));
  // In the hole of a ring, an island that touches its rim in node 5.
  tin = ring();
  std::vector<Point> more(tin.mesh.points().begin(), tin.mesh.points().end());
  more.insert(more.end(), {{1.75, 1.25}, {1.25, 1.75}});
  tin.mesh = test::from_triangles(more, {{0, 1, 4},
                                         {1, 5, 4},
                                         {1, 2, 5},
                                         {2, 6, 5},
                                         {2, 3, 6},
                                         {3, 7, 6},
                                         {3, 0, 7},
                                         {0, 4, 7},
                                         {4, 8, 9}});
  tin.heights.assign(10, 0);
  write_adcirc(tin, folder / "b.14");
  const std::string island = folder.text("b.14");
  CHECK(contains(island, "3 = number of land boundaries\n13 = total"));
  CHECK(contains(island, "4 1 = number of nodes and type"));
  CHECK(contains(island, "5 0 = number of nodes and type"));
  CHECK(contains(island, "4 0 = number of nodes and type"));
}

TEST_CASE("2DM: triangles with their region, then nodes") {
  const ScratchFolder folder;
  write_2dm(small_tin(), folder / "a.2dm");
  CHECK(folder.text("a.2dm") ==
        "MESH2D\nE3T 1 1 2 3 1\nE3T 2 1 3 4 1\nND 1 0 0 0\nND 2 1 0 1.5\nND 3 1 1 -2\nND 4 0 1 "
        "0.1\n");
}

TEST_CASE("a .prj beside the TIN is written, but left as it is where it says the same") {
  const test::ScratchFolder folder;
  WorldTin tin = small_tin();
  tin.crs = "LOCAL_CS[\"site\"]";
  const auto crs_file = folder / "a.prj";
  write_tin(tin, folder / "a.obj");
  CHECK(folder.text("a.prj") == tin.crs + "\n");
  CHECK(is_prj_of(crs_file, tin.crs));
  folder.put("a.prj", tin.crs + " \r\n");
  write_tin(tin, folder / "a.obj");
  CHECK(folder.text("a.prj") == tin.crs + " \r\n");
  for (const std::string other :
       {"", "LOCAL_CS[\"site\"]x", "LOCAL_CS[\"site", "LOCAL_CS[\"sitE\"]"}) {
    CAPTURE(other);
    folder.put("a.prj", other);
    CHECK_FALSE(is_prj_of(crs_file, tin.crs));
    write_tin(tin, folder / "a.obj");
    CHECK(folder.text("a.prj") == tin.crs + "\n");
  }
  CHECK_FALSE(is_prj_of(folder / "none.prj", tin.crs));
  CHECK_FALSE(is_prj_of(folder / "a.obj", tin.crs));
}

TEST_CASE("msh, vtu and ele carry heights") {
  const ScratchFolder folder;
  WorldTin tin = small_tin();
  write_tin(tin, folder / "a.msh");
  CHECK(contains(folder.text("a.msh"), "\n1 0 1.5\n"));
  CHECK(contains(folder.text("a.msh"), "0 0 -2 1 1 1.5 "));  // the box of the surface
  write_tin(tin, folder / "b.msh", {.msh = MshFormat::msh22});
  CHECK(contains(folder.text("b.msh"), "\n2 1 0 1.5\n"));
  write_tin(tin, folder / "a.vtu");
  CHECK(contains(folder.text("a.vtu"), "\n1 0 1.5\n"));
  CHECK(contains(folder.text("a.vtu"), "Name=\"height\" format=\"ascii\">\n0\n1.5\n-2\n0.1\n"));
  write_tin(tin, folder / "a.ele");
  CHECK(folder.text("a.node") == "4 2 1 0\n0 0 0 0\n1 1 0 1.5\n2 1 1 -2\n3 0 1 0.1\n");
  CHECK(folder.text("a.ele") == "2 3 0\n0 0 1 2\n1 0 2 3\n");
  CHECK(mesh_from_triangles(read_ele(folder / "a.ele")).mesh.triangle_count() == 2);
}

TEST_CASE("the name says the format; the reference system goes beside where it has no place") {
  const ScratchFolder folder;
  WorldTin tin = small_tin();
  tin.crs = utm;
  for (const char* name : {"a.obj", "b.ply", "c.stl", "d.14", "e.grd", "f.gr3", "g.2dm", "h.slf",
                           "i.nc", "j.msh", "k.vtu", "l.ele"}) {
    CAPTURE(name);
    CHECK(is_tin_file(name));
    write_tin(tin, folder / name);
    for (const auto& file : tin_files_of(folder / name, true)) {
      CHECK(std::filesystem::exists(file));
      std::filesystem::remove(file);
    }
    CHECK(std::filesystem::is_empty(folder.path()));
  }
  CHECK_FALSE(is_tin_file("a.tif"));
  CHECK(contains(tin_file_kinds(), ".obj, .ply"));
  CHECK(contains(tin_file_kinds(), " or .ele"));
}

TEST_CASE("a mesh that cannot be written leaves no .prj beside it, and the old one alone") {
  const ScratchFolder folder;
  WorldTin tin = small_tin();
  tin.crs = utm;
  std::filesystem::create_directory(folder / "a.stl");
  CHECK(error_of<OutputError>([&] { write_tin(tin, folder / "a.stl"); }) != "");
  CHECK(folder.names() == std::set<std::string>{"a.stl"});
  tin.mesh = test::two_triangles({0, 0}, {1e8, 0}, {1e8, 1e8}, {1e8 - 1, 1e8});
  folder.put("b.prj", "old");
  CHECK(error_of<InputError>([&] { write_tin(tin, folder / "b.stl"); }) != "");
  CHECK(folder.text("b.prj") == "old");
  CHECK(folder.names() == std::set<std::string>{"a.stl", "b.prj"});
  std::filesystem::create_directory(folder / "c.prj");
  CHECK(error_of<OutputError>([&] { write_tin(tin, folder / "c.ply"); }) != "");
  CHECK(folder.names() == std::set<std::string>{"a.stl", "b.prj", "c.prj"});
}
