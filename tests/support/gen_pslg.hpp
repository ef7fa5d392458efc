#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "lepp/geometry/pslg.hpp"

namespace lepp::test {

/// The kinds of input on which mesh generators break.
enum class Family {
  random,          ///< uniform points, segments between some of them, often a frame around
  grid,            ///< lattice points: collinear and cocircular everywhere
  rotated_grid,    ///< the lattice turned by the 3-4-5 angle, exactly or rounded
  ulp_jitter,      ///< lattices, lines and circles with coordinates moved by a few ulp
  offset,          ///< far from the origin, at 1e7 or 1e15
  scale,           ///< scaled by 2^-140 to 2^200, or each coordinate with its own exponent
  small_angles,    ///< fans of segments with angles down to 1e-12
  nested_rings,    ///< rings within rings, with holes and regions between
  touching_holes,  ///< holes that share corners with each other and with the frame
  comb_spiral,     ///< combs and spirals: long segments beside short ones
  overlap,         ///< duplicate points, segments of no length, overlapping and touching segments
  crossings,       ///< segments that cross, at points of the input and elsewhere
};

inline constexpr std::array<std::string_view, 12> family_names{
    "random",       "grid",         "rotated_grid",   "ulp_jitter",  "offset",  "scale",
    "small_angles", "nested_rings", "touching_holes", "comb_spiral", "overlap", "crossings"};

/// One PSLG of a family, the same for the same seed on every machine. P1 and P2 of pslg.hpp hold;
/// segments may cross in any family, though in most they seldom do. Each segment is a curve of its
/// own, with tag 1 + its index, so that its pieces can be told in the mesh.
/// \param points  about how many; 0 lets the seed choose, 5 to 60
Pslg generate_pslg(Family family, std::uint64_t seed, int points = 0);

}  // namespace lepp::test
