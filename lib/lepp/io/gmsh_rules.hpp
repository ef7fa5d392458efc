#pragma once

#include <string>

#include "lepp/io/gmsh_record.hpp"
#include "lepp/io/gmsh_script.hpp"

namespace lepp {

/// The rules a geometry must keep before anything is made of it: there is a surface; all lies in
/// one plane z = constant; every surface has a closed boundary and an area.
/// \throw InputError naming the entity by the user's number
void check_gmsh_geometry(const GmshRecord& record, const GmshScript& script,
                         const std::string& source);

/// \throw InputError naming the two places, unless low and high differ by rounding only
class PlaneCheck {
 public:
  PlaneCheck(const std::string& source, double size) : source_(source), tolerance_(1e-9 * size) {}
  void operator()(double z, const std::string& who);

 private:
  const std::string& source_;
  double tolerance_;
  bool any_ = false;
  double z_ = 0;
  std::string first_;
};

}  // namespace lepp
