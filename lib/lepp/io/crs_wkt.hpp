#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lepp {

/// What a coordinate reference system says of itself as WKT, of version 1, 2 or ESRI's, as far as
/// readers and writers here look at it.
struct CrsWkt {
  bool is_geographic = false;  ///< x and y are longitude and latitude
  std::optional<int> epsg;     ///< the code of the whole system, not of a part of it
  /// Of x and y: in metres, of geographic systems in radians.
  std::optional<double> unit;
  std::optional<double> height_unit;  ///< of the vertical part, if there is one; in metres
};

/// Takes a WKT apart. What is damaged or unknown is passed over.
/// Cost   O(n). Source OGC 01-009 (version 1), OGC 18-010 (version 2)
CrsWkt parse_crs_wkt(std::string_view wkt);

/// "m", "km", "ft" or "US_survey_foot", as UDUNITS knows them; nothing for another length.
std::optional<std::string> name_of_unit(std::optional<double> metres);

}  // namespace lepp
