#include <doctest/doctest.h>

#include <cstdlib>

#include "io/scratch_folder.hpp"
#include "io/small_tins.hpp"
#include "lepp/io/tin_files.hpp"

using namespace lepp;
using test::Bytes;
using test::contains;
using test::ring;
using test::ScratchFolder;
using test::small_tin;
using test::utm;

TEST_CASE("netCDF: header, offsets and values of a small mesh") {
  const ScratchFolder folder;
  write_ugrid(small_tin(), folder / "a.nc");
  const std::string text = folder.text("a.nc");
  CHECK(text.starts_with(std::string("CDF\x02\0\0\0\0\0\0\0\x0A\0\0\0\x05", 16)));
  // The last values are the corners of the triangles, before them the five edges.
  Bytes bytes(text, std::endian::big);
  bytes.go_to(text.size() - 24);
  for (const int v : {1, 2, 3, 1, 3, 4}) CHECK(bytes.next<std::int32_t>() == v);
  bytes.go_to(text.size() - 24 - 40 - 32);
  for (const double h : {0., 1.5, -2., 0.1}) CHECK(bytes.next<double>() == h);
  // The offset of the last variable stands at the end of the header and tells where it starts.
  const std::size_t values = text.size() - 24 - 40 - 3 * 32 - 4;
  bytes.go_to(values - 8);
  CHECK(bytes.next<std::uint64_t>() == text.size() - 24);
  CHECK_FALSE(contains(text, "grid_mapping"));
}

TEST_CASE("netCDF carries the coordinate reference system, degrees by their names") {
  const ScratchFolder folder;
  WorldTin tin = small_tin();
  tin.crs = utm;
  write_ugrid(tin, folder / "a.nc");
  const std::string projected = folder.text("a.nc");
  CHECK(contains(projected, utm));
  CHECK(contains(projected, "projection_x_coordinate"));
  CHECK(contains(projected, std::string("epsg\0\0\0\x04\0\0\0\x01\0\0\x7F\x63", 16)));  // 32611
  tin.degrees = true;
  write_ugrid(tin, folder / "b.nc");
  CHECK(contains(folder.text("b.nc"), "latitude_longitude"));
  CHECK(contains(folder.text("b.nc"), "degrees_north"));
}

TEST_CASE("ncdump reads what we write, where it is installed") {
  if (std::system("command -v ncdump > /dev/null") != 0) return;
  const ScratchFolder folder;
  WorldTin tin = ring();
  tin.crs = utm;
  write_ugrid(tin, folder / "a.nc");
  const std::string out = (folder / "a.cdl").string();
  REQUIRE(std::system(("ncdump '" + (folder / "a.nc").string() + "' > '" + out + "'").c_str()) ==
          0);
  const std::string text = folder.text("a.cdl");
  CHECK(contains(text, "mesh2d_nNodes = 8 ;"));
  CHECK(contains(text, "mesh2d_nEdges = 16 ;"));
  CHECK(contains(text, "mesh2d_node_x = 0, 3, 3, 0, 1, 2, 2, 1 ;"));
  CHECK(contains(text, "projected_coordinate_system = 32611 ;"));
}

TEST_CASE("netCDF: the code of a unit is none of the system, and units are those that it gives") {
  const ScratchFolder folder;
  const auto text_of = [&](const std::string& crs) {
    WorldTin tin = small_tin();
    tin.crs = crs;
    write_ugrid(tin, folder / "a.nc");
    return folder.text("a.nc");
  };
  // A name of five letters, a text as type, its length, and the text, each filled up to four.
  const auto units = [](const std::string& unit) {
    std::string text("units\0\0\0\0\0\0\x02\0\0\0", 15);
    text += static_cast<char>(unit.size());
    return text + unit;
  };
  const auto custom = [](const std::string& unit) {
    return R"(PROJCS["x",GEOGCS["y",AUTHORITY["EPSG","4326"]],UNIT[)" + unit +
           R"(,AUTHORITY["EPSG","9001"]],AXIS["e",EAST],AXIS["n",NORTH]])";
  };
  const std::string metric = text_of(custom("\"metre\",1"));
  CHECK_FALSE(contains(metric, std::string("epsg\0\0\0\x04", 8)));
  CHECK(contains(metric, units("m")));
  const std::string feet = text_of(custom("\"US survey foot\",0.3048006096012192"));
  CHECK(contains(feet, units("US_survey_foot")));
  CHECK_FALSE(contains(feet, units("m")));
  CHECK(contains(
      text_of("COMPD_CS[\"z\"," + custom("\"foot\",0.3048") + R"(,VERT_CS["v",UNIT["metre",1]]])"),
      units("m")));
  CHECK_FALSE(contains(text_of(custom("\"rod\",5.0292")), "units"));
  CHECK_FALSE(contains(text_of(""), "units"));
}
