#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lepp/triangulation/mesh.hpp"

namespace lepp {

/// Why a triangle breaks a bound that was asked for.
enum class Reason {
  input_angle,    ///< forced by two constrained edges that meet below 60 degrees
  input_feature,  ///< the input is finer than twice the size floor there
  size_floor,     ///< splits there end at edges too short for the coordinates
  budget,         ///< --max-vertices, or the default budget, is used up, or a part of it in vain
  cancelled,      ///< the caller said stop
  method,         ///< the method asked for does not promise more (the paper's post-process)
  kept_border,    ///< a side of the domain would have to be cut that the caller wants whole
};
std::string to_string(Reason reason);

/// True for reasons that the input forces; the goal counts as reached all the same.
bool is_forced_by_input(Reason reason);

struct Unfinished {
  TriangleId triangle;
  Reason reason;
  friend bool operator==(const Unfinished&, const Unfinished&) = default;
};

/// The reasons that the input of a mesh forces on triangles with a small angle or an obtuse one.
/// Both refine() and validate() decide by it.
class InputReasons {
 public:
  /// Looks at the mesh as it is now. Cost O(triangles)
  explicit InputReasons(const Mesh& mesh);

  /// True where the smallest angle of `t` lies in a wedge of constrained edges below 60 degrees,
  /// or its shortest edge is seditious there. Excuses a small angle, never a large one.
  bool by_angle(TriangleId t) const;
  /// True where the input is finer than twice the size floor: separate parts of it are closer, or a
  /// segment is shorter.
  bool by_feature(TriangleId t) const;
  /// input_angle or input_feature, if one of them holds, in this order.
  std::optional<Reason> of(TriangleId t) const;

 private:
  const Mesh& mesh_;
  double floor_;
  std::vector<std::uint8_t> in_sharp_wedge_;  // a bit per corner
};

/// True if two constrained edges enclose the smallest angle of `t`, and it is so small that their
/// doubles no longer say which of the two is longer, or by how much: of 4 ulp of the largest
/// coordinate, another angle is obtuse. No coordinates make it better. The one way in which an
/// input angle excuses an obtuse one.
bool is_obtuse_by_rounding(const Mesh& mesh, TriangleId t);

/// The shortest edge that refinement makes: below it doubles are too coarse, 1e-12 of the diagonal
/// of the bounding box or 64 ulp of the largest coordinate.
double default_size_floor(const Mesh& mesh);

}  // namespace lepp
