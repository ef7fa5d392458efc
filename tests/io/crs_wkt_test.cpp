#include "lepp/io/crs_wkt.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace lepp;

namespace {

const std::string wgs84 =
    R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563,AUTHORITY["EPSG",)"
    R"("7030"]]],UNIT["degree",0.0174532925199433,AUTHORITY["EPSG","9122"]],AUTHORITY["EPSG",)"
    R"("4326"]])";

std::string projected(const std::string& rest) {
  return R"(PROJCS["a, ""b"" [c]",)" + wgs84 + R"(,PROJECTION["Transverse_Mercator"],)" + rest +
         "]";
}

}  // namespace

TEST_CASE("the EPSG code of a WKT is that of the whole, not of a unit, a datum or an axis") {
  const std::string metre = R"(UNIT["metre",1,AUTHORITY["EPSG","9001"]])";
  CHECK(parse_crs_wkt(wgs84).epsg == 4326);
  CHECK(parse_crs_wkt(projected(metre)).epsg == std::nullopt);
  CHECK(parse_crs_wkt(projected(metre + R"(,AXIS["x",EAST],AXIS["y",NORTH])")).epsg ==
        std::nullopt);
  CHECK(parse_crs_wkt(projected(metre + R"(,AUTHORITY["EPSG","32632"])")).epsg == 32632);
  CHECK(parse_crs_wkt(projected(R"(AUTHORITY [ "EPSG" , "32632" ] , )" + metre)).epsg == 32632);
  CHECK(parse_crs_wkt(projected(metre + R"(,AUTHORITY["ESRI","102003"])")).epsg == std::nullopt);
  CHECK(parse_crs_wkt(R"(PROJCRS["x",BASEGEOGCRS["y",ID["EPSG",4326]],ID["EPSG",32611]])").epsg ==
        32611);
  CHECK(parse_crs_wkt(R"(COMPD_CS["x",)" + projected(R"(AUTHORITY["EPSG","32632"])") + "]").epsg ==
        std::nullopt);
}

TEST_CASE("units are those of the horizontal and of the vertical part of a WKT") {
  const std::string foot = R"(UNIT["US survey foot",0.304800609601219])";
  CHECK(parse_crs_wkt(projected(foot)).unit == 0.304800609601219);
  CHECK(parse_crs_wkt(projected("")).unit == std::nullopt);
  CHECK(!parse_crs_wkt(projected(foot)).is_geographic);
  CHECK(parse_crs_wkt(wgs84).unit == 0.0174532925199433);
  CHECK(parse_crs_wkt(wgs84).is_geographic);
  const CrsWkt compound = parse_crs_wkt(R"(COMPD_CS["x",)" + projected(foot) +
                                        R"(,VERT_CS["z",VERT_DATUM["z",2005],UNIT["metre",1]]])");
  CHECK(compound.unit == 0.304800609601219);
  CHECK(compound.height_unit == 1);
  CHECK(parse_crs_wkt(projected(foot)).height_unit == std::nullopt);
}

TEST_CASE("WKT of version 2: units of axes, and systems bound to another") {
  const std::string crs =
      R"(PROJCRS["x",BASEGEOGCRS["y",PRIMEM["z",0,ANGLEUNIT["degree",0.0174532925199433]]],)"
      R"(CONVERSION["c",PARAMETER["e",5,LENGTHUNIT["metre",1]]],CS[Cartesian,2],)"
      R"-(AXIS["(E)",east,ORDER[1],LENGTHUNIT["foot",0.3048]],)-"
      R"-(AXIS["(N)",north,ORDER[2],LENGTHUNIT["foot",0.3048]],ID["EPSG",2222]])-";
  CHECK(parse_crs_wkt(crs).unit == 0.3048);
  CHECK(parse_crs_wkt("BOUNDCRS[SOURCECRS[" + crs + "],TARGETCRS[" + wgs84 + "]]").unit == 0.3048);
  const CrsWkt geographic = parse_crs_wkt(
      R"(GEOGCRS["g",CS[ellipsoidal,2],AXIS["lat",north,ANGLEUNIT["grad",0.015707963]]])");
  CHECK(geographic.is_geographic);
  CHECK(geographic.unit == 0.015707963);
}

TEST_CASE("text that is no WKT, or is cut short, says nothing and does no harm") {
  const std::string whole = projected(R"(UNIT["metre",1],AUTHORITY["EPSG","32632"])");
  CHECK(parse_crs_wkt(whole).epsg == 32632);
  for (std::size_t n = 0; n < whole.size(); ++n) {
    CAPTURE(n);
    CHECK(parse_crs_wkt(whole.substr(0, n)).epsg != 4326);
  }
  CHECK(parse_crs_wkt("").unit == std::nullopt);
  CHECK(parse_crs_wkt(std::string(100'000, '[')).unit == std::nullopt);
  CHECK(parse_crs_wkt("]],\"EPSG\",[").epsg == std::nullopt);
}
